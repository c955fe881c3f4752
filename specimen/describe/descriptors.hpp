/// What the aggregates of a specimen look like, in figures.
#pragma once

#include <vector>

#include "specimen/describe/aggregate_sample.hpp"
#include "specimen/describe/orientation.hpp"
#include "specimen/describe/statistics.hpp"

namespace specimen {

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
