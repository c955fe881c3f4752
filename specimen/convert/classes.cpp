#include "specimen/convert/classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <unordered_map>

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

namespace {

constexpr std::size_t most_bins = 1024;

/// Occupied bins in rising order.
struct Histogram {
  std::vector<double> level;  ///< middle of the bin
  std::vector<double> count;
};

/// How often each value occurs; nothing where there are more than there are bins.
std::optional<std::unordered_map<double, double>> few_values(const Raster<double>& values) {
  std::unordered_map<double, double> found;
  for (const double v : values.data)
    if (++found[v] == 1 && found.size() > most_bins) return std::nullopt;
  return found;
}

Histogram histogram(const Raster<double>& values) {
  Histogram h;
  if (const auto few = few_values(values)) {
    for (const auto& [level, count] : *few) h.level.push_back(level);
    std::sort(h.level.begin(), h.level.end());
    for (const double level : h.level) h.count.push_back(few->at(level));
    return h;
  }
  const auto [low, high] = std::minmax_element(values.data.begin(), values.data.end());
  const double start = *low, width = (*high - *low) / most_bins;
  std::vector<double> counts(most_bins, 0);
  for (const double v : values.data)
    ++counts[static_cast<std::size_t>(std::min(most_bins - 1.0, (v - start) / width))];
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) {
      h.level.push_back(start + (static_cast<double>(i) + 0.5) * width);
      h.count.push_back(counts[i]);
    }
  return h;
}

/// Running sums that give the squared deviation of any run of bins at once.
class Deviation {
 public:
  explicit Deviation(const Histogram& h) : count_{0}, sum_{0}, square_{0} {
    double total = 0, moment = 0;
    for (std::size_t i = 0; i < h.level.size(); ++i) {
      total += h.count[i];
      moment += h.count[i] * h.level[i];
    }
    const double mean = moment / total;  // taken off, so that the squares stay small
    for (std::size_t i = 0; i < h.level.size(); ++i) {
      const double x = h.level[i] - mean;
      count_.push_back(count_.back() + h.count[i]);
      sum_.push_back(sum_.back() + h.count[i] * x);
      square_.push_back(square_.back() + h.count[i] * x * x);
    }
  }
  /// Of bins first ... last - 1.
  [[nodiscard]] double operator()(std::size_t first, std::size_t last) const {
    const double n = count_[last] - count_[first], s = sum_[last] - sum_[first];
    return square_[last] - square_[first] - s * s / n;
  }

 private:
  std::vector<double> count_, sum_, square_;
};

/// First bin of each class but the darkest, by dynamic programming over the end of each class.
std::vector<std::size_t> best_cuts(const Deviation& deviation, std::size_t bins, std::size_t classes) {
  std::vector<double> cost(bins + 1);
  for (std::size_t end = 1; end <= bins; ++end) cost[end] = deviation(0, end);
  std::vector<std::vector<std::size_t>> start_of(classes, std::vector<std::size_t>(bins + 1, 0));
  for (std::size_t k = 1; k < classes; ++k) {
    std::vector<double> next(bins + 1, std::numeric_limits<double>::infinity());
    for (std::size_t end = k + 1; end <= bins; ++end)
      for (std::size_t start = k; start < end; ++start)
        if (const double c = cost[start] + deviation(start, end); c < next[end]) {
          next[end] = c;
          start_of[k][end] = start;
        }
    cost = std::move(next);
  }
  std::vector<std::size_t> cuts;
  for (std::size_t k = classes - 1, end = bins; k > 0; --k) cuts.push_back(end = start_of[k][end]);
  std::reverse(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

Raster<std::uint8_t> classes_between(const Raster<double>& values, const std::vector<double>& thresholds) {
  Raster<std::uint8_t> classes(values.rows, values.cols);
  std::transform(values.data.begin(), values.data.end(), classes.data.begin(), [&](double v) {
    return static_cast<std::uint8_t>(std::upper_bound(thresholds.begin(), thresholds.end(), v) -
                                     thresholds.begin());
  });
  return classes;
}

std::vector<double> otsu_thresholds(const Raster<double>& values, int classes) {
  const Histogram h = histogram(values);
  const std::size_t wanted = std::min(static_cast<std::size_t>(classes), h.level.size());
  std::vector<double> thresholds;
  for (const std::size_t cut : best_cuts(Deviation(h), h.level.size(), wanted))
    thresholds.push_back((h.level[cut - 1] + h.level[cut]) / 2);
  return thresholds;
}

}  // namespace specimen
