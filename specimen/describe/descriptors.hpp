/// Whether long axes point somewhere.
/// How near aggregates lie to each other, and how far they are from being convex.
/// What the aggregates of a specimen look like, in figures.
#pragma once

#include <vector>

#include "specimen/body/specimen.hpp"
#include "specimen/describe/aggregate_sample.hpp"
#include "specimen/describe/statistics.hpp"

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

/// Distance from the outline of each inclusion to the nearest outline of another one [m], in the order of
/// the list; nought where they touch. Outlines are looked at a pixel apart, so distances are right to a
/// fraction of a pixel. Empty with fewer than two inclusions.
[[nodiscard]] std::vector<double> nearest_gaps(const Specimen& specimen);

/// Area over that of the convex hull [-]; 1 for an exact ellipse. Grains that were taken for one are low.
[[nodiscard]] double solidity(const Inclusion& inclusion);

/// Statistical descriptors of one specimen. Means are over the area of the aggregates, so that specks, of
/// which pixels tell little, count for little.
struct Descriptors {
  double width = 0;               ///< [m]
  double height = 0;              ///< [m]
  double pixel_size = 0;          ///< [m]
  double fraction = 0;            ///< of aggregate, by pixels [-]
  double void_fraction = 0;       ///< of voids, by pixels [-]
  double specific_perimeter = 0;  ///< boundary of the aggregates over the area of the specimen [1/m]
  AggregateSample sample;
  double median_diameter = 0;  ///< half of the aggregate area is in aggregates up to that [m]; NaN: none
  double mean_aspect = 0;      ///< short over long axis [-]; NaN: none
  Orientation orientation;     ///< of the long axes
  std::vector<double> gaps;    ///< from each aggregate to its nearest neighbour [m], rising
  double mean_gap = 0;         ///< of these [m]; NaN: fewer than two aggregates
  int merged = 0;              ///< aggregates so far from convex that they may be several
  TwoPoint s2;                 ///< of aggregate
};

[[nodiscard]] Descriptors describe(const Specimen& specimen);

/// Lowest solidity that a single grain has: two equal discs that touch have 0.88.
inline constexpr double least_solidity = 0.9;

}  // namespace specimen
