/// Random packing of ellipses with an exact minimum gap; and checks of its options, which report all faults
/// at once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/error.hpp"
#include "specimen/pack/grading.hpp"

namespace specimen {

/// Options of a packing.
struct PackingOptions {
  double width = 0.150;    ///< of the specimen [m]
  double height = 0.150;   ///< of the specimen [m]
  double fraction = 0.45;  ///< aggregate area over specimen area [-], 0 to 0.9
  Grading grading = named_grading("fuller", 5e-3, 20e-3);
  double aspect_min = 0.5;  ///< smallest b / a [-], >= 0.02
  double aspect_max = 1.0;  ///< largest b / a [-]
  double gap = 0.5e-3;      ///< smallest distance to each other and to the walls [m]
  std::uint64_t seed = 1;   ///< of the random numbers
};

/// A packing of ellipses.
struct Packing {
  std::vector<Ellipse> ellipses;  ///< largest first
  double fraction = 0;            ///< area fraction reached, of exact ellipse areas [-]
  bool relaxed = false;           ///< random placement was not enough and overlaps were relaxed
};

/// Place random ellipses that fill the area fraction exactly: sizes are drawn class by class and scaled by
/// one factor close to 1, within their limits. Random placement first; relaxation of overlaps if this is not
/// enough. Same options, same bits on any machine. Fraction 0 gives no ellipses.
/// @throws Error for options out of range, and if the fraction cannot be reached: with the fraction that was
/// reached (for more than 1000 aggregates, in a part of the specimen), the limiting option and what to try.
[[nodiscard]] Packing pack(const PackingOptions& options);

/// Every option that is out of range; empty for valid options.
[[nodiscard]] std::vector<Error> faults(const PackingOptions& options);

/// Faults of the three sizes [m]: not positive, not a whole number of pixels, or too many pixels.
/// @param group  prefix of the field names, e.g. "generate".
[[nodiscard]] std::vector<Error> canvas_faults(double width, double height, double pixel_size,
                                               const std::string& group);

}  // namespace specimen
