#include "specimen/convert/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace specimen {
namespace {

constexpr int most_bins = 1024;

/// Occupied bins in rising order.
struct Histogram {
  std::vector<double> level;  ///< middle of the bin
  std::vector<double> count;
};

Histogram histogram(const Raster<double>& values) {
  const auto [low, high] = std::minmax_element(values.data.begin(), values.data.end());
  const double start = *low, span = *high - *low;
  const bool whole =
      std::all_of(values.data.begin(), values.data.end(), [](double v) { return v == std::floor(v); });
  const bool exact = whole && span < most_bins;
  const double width = exact || span == 0 ? 1 : span / most_bins;
  std::vector<double> counts(most_bins, 0);
  for (const double v : values.data)
    ++counts[static_cast<std::size_t>(std::min(most_bins - 1.0, (v - start) / width))];
  Histogram h;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) {
      h.level.push_back(start + (static_cast<double>(i) + (exact ? 0.0 : 0.5)) * width);
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
