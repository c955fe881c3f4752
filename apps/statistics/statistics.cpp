#include "apps/statistics/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace app {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Least-squares slope of y over x.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const double x_mean = mean_of(x), y_mean = mean_of(y);
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - x_mean) * (y[i] - y_mean);
    xx += (x[i] - x_mean) * (x[i] - x_mean);
  }
  return xx > 0 ? xy / xx : no_number;
}

/// Place of each value among all; equal ones share the middle of their places.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> ranks;
  for (const double value : values) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    const auto less = first - sorted.begin(), equal = last - first;
    ranks.push_back(static_cast<double>(less) + 0.5 * static_cast<double>(equal - 1));
  }
  return ranks;
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  const std::vector<double> finite = finite_of(values);
  if (finite.empty()) return {no_number, no_number, no_number, no_number};
  const double mean = mean_of(finite);
  double squares = 0;
  for (const double value : finite) squares += (value - mean) * (value - mean);
  const auto freedom = static_cast<double>(finite.size() - 1);
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
  return {mean, freedom > 0 ? std::sqrt(squares / freedom) : 0, *low, *high};
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2 || !all_finite(x) || !all_finite(y)) return no_number;
  const std::vector<double> x_ranks = ranks(x), y_ranks = ranks(y);
  const double forth = slope(x_ranks, y_ranks), back = slope(y_ranks, x_ranks);
  return std::isfinite(back) ? std::copysign(std::sqrt(forth * back), forth) : 0;
}

double power_of(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> log_x, log_y;
  for (const double value : x) log_x.push_back(std::log(value));
  for (const double value : y) log_y.push_back(std::log(value));
  return slope(log_x, log_y);
}

double share_within(const std::vector<double>& values, double low, double high) {
  const auto inside =
      std::count_if(values.begin(), values.end(), [&](double v) { return low <= v && v <= high; });
  return values.empty() ? no_number : static_cast<double>(inside) / static_cast<double>(values.size());
}

double quantile_of(std::vector<double> values, double p) {
  if (values.empty()) return no_number;
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> finite_of(const std::vector<double>& values) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double v) { return std::isfinite(v); });
  return finite;
}

namespace {

constexpr double upper_tail = 0.025;
constexpr std::size_t most_values = 100'000'000;

/// Half width of the interval over the standard deviation.
double width_factor(std::size_t count) {
  const auto n = static_cast<double>(count);
  const boost::math::students_t student(n - 1);
  return boost::math::quantile(boost::math::complement(student, upper_tail)) / std::sqrt(n);
}

}  // namespace

double MeanEstimate::relative_half_width() const { return half_width / std::abs(mean); }

MeanEstimate mean_estimate(const std::vector<double>& values) {
  const std::size_t count = finite_of(values).size();
  const Spread spread = spread_of(values);
  return {count, spread.mean, spread.deviation,
          count < 2 ? no_number : width_factor(count) * spread.deviation};
}

std::size_t values_needed(const MeanEstimate& estimate, double share) {
  const double wanted = share * std::abs(estimate.mean) / estimate.deviation;
  if (estimate.count < 2 || std::isnan(wanted)) return 0;
  std::size_t enough = 2;
  while (width_factor(enough) > wanted)
    if ((enough *= 2) > most_values) return 0;
  std::size_t too_few = enough / 2;  // the factor falls with the count
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (width_factor(middle) > wanted ? too_few : enough) = middle;
  }
  return enough;
}

}  // namespace app
