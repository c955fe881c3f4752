/// Whether long axes point somewhere.
#pragma once

#include <vector>

namespace specimen {

/// An axis without a sense, with a weight.
struct WeightedAxis {
  double angle = 0;   ///< against x [rad]; angle and angle + pi are the same
  double weight = 1;  ///< [-], >= 0
};

/// Mean direction of axes and whether they have one.
struct Orientation {
  double direction = 0;    ///< of the mean, [0, pi) [rad]
  double strength = 0;     ///< mean resultant length: 0 = as many across as along, 1 = all parallel [-]
  double probability = 1;  ///< that axes of random directions come out as strong or stronger [-]
};

/// Rayleigh test of uniformity on doubled angles; weights count by their effective number, (sum w)^2 / sum
/// w^2. No axes: strength 0, probability 1.
/// Source: Fisher (1993), Statistical Analysis of Circular Data, eq. 4.17.
[[nodiscard]] Orientation mean_orientation(const std::vector<WeightedAxis>& axes);

}  // namespace specimen
