/// Random ellipses at an exact minimum gap, largest first.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/ellipse.hpp"
#include "specimen/grading.hpp"

namespace specimen {

struct PackingOptions {
  double width = 0.150;    ///< of the specimen [m]
  double height = 0.150;   ///< of the specimen [m]
  double fraction = 0.45;  ///< aggregate area over specimen area [-]
  Grading grading = named_grading("fuller", 5e-3, 20e-3);
  double aspect_min = 0.5;  ///< least b / a [-]
  double aspect_max = 1.0;  ///< largest b / a [-]
  double gap = 0.5e-3;      ///< least distance to each other and to the walls [m]
  std::uint64_t seed = 1;
};

struct Packing {
  std::vector<Ellipse> ellipses;  ///< largest first
  double fraction = 0;            ///< reached, of exact ellipse areas [-]
  bool relaxed = false;           ///< true when plain placement was not enough and overlaps were relaxed
};

/// Place random ellipses until the target fraction is reached within half of the smallest aggregate's area
/// (the last one is scaled to meet it exactly). Plain placement first; overlap relaxation where that is not
/// enough. Same options, same result on any machine.
/// @throws Error with the fraction reached and what limits it.
[[nodiscard]] Packing pack(const PackingOptions& options);

}  // namespace specimen
