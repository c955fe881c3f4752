/// Statistical descriptors of the aggregates of a specimen: fraction, sizes, shapes, orientation, distances.
#pragma once

#include <vector>

#include "specimen/body/specimen.hpp"
#include "specimen/describe/aggregate_sample.hpp"
#include "specimen/describe/statistics.hpp"

namespace specimen {

/// An undirected axis with a weight.
struct WeightedAxis {
  double angle = 0;   ///< from x [rad]; angle and angle + pi are the same axis
  double weight = 1;  ///< [-], >= 0
};

/// Mean direction of axes, and its significance.
struct Orientation {
  double direction = 0;    ///< mean direction [rad], in [0, pi)
  double strength = 0;     ///< mean resultant length [-]: 0 = no preferred direction, 1 = all parallel
  double probability = 1;  ///< probability of this strength or more for random directions [-]
};

/// Rayleigh test of uniformity on doubled angles, with the effective sample size (sum w)^2 / sum w^2. Without
/// axes strength 0 and probability 1. Source: Fisher (1993), Statistical Analysis of Circular Data, eq. 4.17.
[[nodiscard]] Orientation mean_orientation(const std::vector<WeightedAxis>& axes);

/// Distance from the outline of each inclusion to the nearest outline of another one [m], in the order of the
/// inclusions; 0 if they touch. Outlines are sampled at steps of one pixel, so the error is a fraction of a
/// pixel. Empty for fewer than two inclusions.
[[nodiscard]] std::vector<double> nearest_gaps(const Specimen& specimen);

/// Area over area of the convex hull [-]; 1 for an exact ellipse, small for touching grains that were not
/// split.
[[nodiscard]] double solidity(const Inclusion& inclusion);

/// Statistical descriptors of one specimen. Means are weighted by aggregate area, so that aggregates of a few
/// pixels count little.
struct Descriptors {
  double width = 0;               ///< of the specimen [m]
  double height = 0;              ///< of the specimen [m]
  double pixel_size = 0;          ///< edge of a pixel [m]
  double fraction = 0;            ///< of aggregate, by pixels [-]
  double void_fraction = 0;       ///< of voids, by pixels [-]
  double specific_perimeter = 0;  ///< boundary of the aggregates over the area of the specimen [1/m]
  AggregateSample sample;         ///< sizes and shapes
  double median_diameter =
      0;  ///< half of the aggregate area is in aggregates up to this [m]; NaN = no aggregates
  double mean_aspect = 0;    ///< short over long axis [-]; NaN = no aggregates
  Orientation orientation;   ///< of the long axes
  std::vector<double> gaps;  ///< from each aggregate to its nearest neighbour [m], increasing
  double mean_gap = 0;       ///< mean of gaps [m]; NaN = fewer than two aggregates
  int merged = 0;            ///< aggregates with a solidity below least_solidity: possibly several
  TwoPoint s2;               ///< two-point probability of aggregate
};

/// The descriptors of a specimen.
[[nodiscard]] Descriptors describe(const Specimen& specimen);

/// Smallest solidity of a single grain [-]; two equal discs that touch have 0.88.
inline constexpr double least_solidity = 0.9;

}  // namespace specimen
