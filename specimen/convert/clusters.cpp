#include "specimen/convert/clusters.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace specimen {
namespace {

double squared_distance(const Position& a, const Position& b) {
  double sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

/// First index at which the running sum of the weights passes a random share of their total.
std::size_t draw(const std::vector<double>& weights, std::mt19937_64& random) {
  double total = 0;
  for (const double w : weights) total += w;
  double left = total * (static_cast<double>(random() >> 11) * 0x1p-53);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    left -= weights[i];
    if (left < 0) return i;
  }
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

/// Starting centres: each one drawn with a chance that grows with its distance to those before it.
std::vector<Position> spread_out(const std::vector<WeightedPoint>& points, int count,
                                 std::mt19937_64& random) {
  std::vector<Position> centres;
  std::vector<double> chance(points.size());
  std::transform(points.begin(), points.end(), chance.begin(), [](const auto& p) { return p.weight; });
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  while (static_cast<int>(centres.size()) < count) {
    if (*std::max_element(chance.begin(), chance.end()) <= 0) break;  // every distinct point is a centre
    centres.push_back(points[draw(chance, random)].at);
    for (std::size_t i = 0; i < points.size(); ++i) {
      distance[i] = std::min(distance[i], squared_distance(points[i].at, centres.back()));
      chance[i] = points[i].weight * distance[i];
    }
  }
  return centres;
}

/// One step of Lloyd's iteration.   @return the spread before the step.
double move_centres(const std::vector<WeightedPoint>& points, std::vector<Position>& centres) {
  std::vector<Position> sum(centres.size(), Position{});
  std::vector<double> weight(centres.size(), 0);
  double spread = 0;
  for (const WeightedPoint& p : points) {
    const auto k = static_cast<std::size_t>(nearest(centres, p.at));
    spread += p.weight * squared_distance(p.at, centres[k]);
    for (std::size_t d = 0; d < p.at.size(); ++d) sum[k][d] += p.weight * p.at[d];
    weight[k] += p.weight;
  }
  for (std::size_t k = 0; k < centres.size(); ++k)
    if (weight[k] > 0)
      for (std::size_t d = 0; d < centres[k].size(); ++d) centres[k][d] = sum[k][d] / weight[k];
  return spread;
}

}  // namespace

int nearest(const std::vector<Position>& centres, const Position& at) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < centres.size(); ++k)
    if (const double d = squared_distance(centres[k], at); d < least) {
      least = d;
      best = static_cast<int>(k);
    }
  return best;
}

Clusters find_clusters(const std::vector<WeightedPoint>& points, int count) {
  constexpr int starts = 5, most_steps = 60;
  constexpr double settled = 1e-6;  // relative gain of a step
  std::mt19937_64 random(1);
  Clusters best;
  best.spread = std::numeric_limits<double>::infinity();
  if (points.empty()) return {};
  for (int start = 0; start < starts; ++start) {
    std::vector<Position> centres = spread_out(points, count, random);
    double spread = move_centres(points, centres);
    for (int i = 0; i < most_steps; ++i) {
      const double before = spread;
      spread = move_centres(points, centres);
      if (before - spread <= settled * before) break;
    }
    if (spread < best.spread) best = {std::move(centres), spread};
  }
  return best;
}

}  // namespace specimen
