/// Classification: k-means, and Otsu's thresholds for any number of classes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// A point of up to four coordinates.
using Position = std::array<double, 4>;

/// A point that represents `weight` equal points.
struct WeightedPoint {
  Position at{};
  double weight = 1;
};

struct Clusters {
  std::vector<Position> centres;
  double spread = 0;  ///< sum of weighted squared distances to the centres
};

/// Index of the nearest centre; the first of several equally near ones.
[[nodiscard]] int nearest(const std::vector<Position>& centres, const Position& at);

/// k-means by Lloyd's iteration, the best of five starts drawn by k-means++ from a fixed seed: the same
/// points give the same centres on any machine. Fewer distinct points than `count` give fewer centres.
/// Source: Arthur, Vassilvitskii (2007), k-means++.
[[nodiscard]] Clusters find_clusters(const std::vector<WeightedPoint>& points, int count);

/// Class of each pixel: the number of thresholds that its value reaches, so class 0 is the darkest.
/// @param thresholds  rising, at most 255 of them.
[[nodiscard]] Raster<std::uint8_t> classes_between(const Raster<double>& values,
                                                   const std::vector<double>& thresholds);

/// Thresholds that cut the values into `classes` with the least sum of squared deviations within the classes
/// (Otsu's criterion), exact for the histogram: one bin per value for up to 1024 different ones, in
/// whatever unit, otherwise 1024 bins. Fewer occupied bins than classes give fewer thresholds. Source: Otsu
/// (1979); the dynamic programme over class ends is that of Fisher (1958).
[[nodiscard]] std::vector<double> otsu_thresholds(const Raster<double>& values, int classes);

}  // namespace specimen
