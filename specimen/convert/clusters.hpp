/// k-means: points gathered into classes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace specimen {

/// A point of up to four coordinates.
using Position = std::array<double, 4>;

/// A point that stands for `weight` equal ones.
struct WeightedPoint {
  Position at{};
  double weight = 1;
};

struct Clusters {
  std::vector<Position> centres;
  double spread = 0;  ///< sum of weighted squared distances to the centres
};

/// Index of the nearest centre; the first of equally near ones.
[[nodiscard]] int nearest(const std::vector<Position>& centres, const Position& at);

/// k-means by Lloyd's iteration, the best of five starts drawn by k-means++ from a fixed seed: the same
/// points give the same centres on any machine. Fewer distinct points than `count` give fewer centres.
/// Source: Arthur, Vassilvitskii (2007), k-means++.
[[nodiscard]] Clusters find_clusters(const std::vector<WeightedPoint>& points, int count);

}  // namespace specimen
