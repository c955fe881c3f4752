/// Random ellipses at an exact minimum gap, largest first.
/// All that is wrong with a specimen that is to be drawn, at once; who draws it throws the first of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/error.hpp"
#include "specimen/pack/grading.hpp"

namespace specimen {

struct PackingOptions {
  double width = 0.150;    ///< of the specimen [m]
  double height = 0.150;   ///< of the specimen [m]
  double fraction = 0.45;  ///< aggregate area over specimen area [-], 0 to 0.9
  Grading grading = named_grading("fuller", 5e-3, 20e-3);
  double aspect_min = 0.5;  ///< least b / a [-], >= 0.02
  double aspect_max = 1.0;  ///< largest b / a [-]
  double gap = 0.5e-3;      ///< least distance to each other and to the walls [m]
  std::uint64_t seed = 1;
};

struct Packing {
  std::vector<Ellipse> ellipses;  ///< largest first
  double fraction = 0;            ///< reached, of exact ellipse areas [-]
  bool relaxed = false;           ///< true when plain placement was not enough and overlaps were relaxed
};

/// Place random ellipses that fill the target fraction exactly: sizes are drawn class by class, then all of
/// them are scaled by one factor near 1 within their limits. Plain placement first; overlap relaxation where
/// that is not enough. Same options, same bits on any machine. Fraction 0 gives no ellipse.
/// @throws Error for options out of range, and when the fraction cannot be filled: with the fraction that
/// was reached (for more than 1000 aggregates: in a part of the specimen), what limits it and what to try.
[[nodiscard]] Packing pack(const PackingOptions& options);

/// Every option that is out of range; none of options that can be tried.
[[nodiscard]] std::vector<Error> faults(const PackingOptions& options);

/// Every one of the three sizes [m] that is not positive or no whole number of pixels, or makes too many of
/// them.   @param group  of the fields in errors: "generate".
[[nodiscard]] std::vector<Error> canvas_faults(double width, double height, double pixel_size,
                                               const std::string& group);

}  // namespace specimen
