#include "apps/statistics/influences.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "apps/statistics/statistics.hpp"

namespace app {
namespace {

/// Squared distances of the values begin ... end from their mean.
double squares(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  double sum = 0, result = 0;
  for (std::size_t i = begin; i < end; ++i) sum += values[i];
  const double mean = sum / static_cast<double>(end - begin);
  for (std::size_t i = begin; i < end; ++i) result += (values[i] - mean) * (values[i] - mean);
  return result;
}

std::vector<std::size_t> order_of(const std::vector<double>& x) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  return order;
}

/// Where classes of rising x end.
std::vector<std::size_t> class_ends(const std::vector<double>& rising) {
  const std::size_t count = rising.size();
  const auto wanted = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(count))));
  const bool few = std::set<double>(rising.begin(), rising.end()).size() <= wanted;
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i <= wanted && !few; ++i) ends.push_back(i * count / wanted);
  for (std::size_t i = 1; i <= count && few; ++i)
    if (i == count || rising[i] != rising[i - 1]) ends.push_back(i);
  return ends;
}

}  // namespace

double significance_of(double rank_correlation, std::size_t count) {
  if (count < 4 || !std::isfinite(rank_correlation)) return no_number;
  const double freedom = static_cast<double>(count) - 2;
  const double rest = 1 - rank_correlation * rank_correlation;
  if (!(rest > 0)) return 0;
  const double t = std::abs(rank_correlation) * std::sqrt(freedom / rest);
  return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(freedom), t));
}

double first_order_index(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> rising, along;
  for (const std::size_t i : order_of(x)) {
    rising.push_back(x[i]);
    along.push_back(y[i]);
  }
  const std::vector<std::size_t> ends = class_ends(rising);
  if (ends.size() < 2 || ends.size() >= y.size()) return no_number;
  double within = 0;
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    within += squares(along, begin, end);
    begin = end;
  }
  const double total = squares(along, 0, along.size());
  const auto n = static_cast<double>(y.size()), classes = static_cast<double>(ends.size());
  return total > 0 ? 1 - within / (n - classes) / (total / (n - 1)) : no_number;
}

namespace {

constexpr double reach = 100;  ///< how far beyond the sizes the transition is looked for
constexpr int bits = 26;       ///< of the minimum; it is flat to half the digits of a double

double shape(double size, double transition) { return 1 / std::sqrt(1 + size / transition); }

/// The best strength of small specimens for a transition.
double best_plastic(const std::vector<double>& sizes, const std::vector<double>& strengths,
                    double transition) {
  double product = 0, square = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double factor = shape(sizes[i], transition);
    product += factor * strengths[i];
    square += factor * factor;
  }
  return product / square;
}

double misfit(const std::vector<double>& sizes, const std::vector<double>& strengths, double transition) {
  const double plastic = best_plastic(sizes, strengths, transition);
  double sum = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    sum += std::pow(strengths[i] - plastic * shape(sizes[i], transition), 2);
  return sum;
}

}  // namespace

double SizeEffect::strength(double size) const { return plastic * shape(size, transition); }

SizeEffect fit_size_effect(const std::vector<double>& sizes, const std::vector<double>& strengths) {
  const auto [least, largest] = std::minmax_element(sizes.begin(), sizes.end());
  const double low = std::log(*least / reach), high = std::log(*largest * reach);
  const auto [log_transition, rest] = boost::math::tools::brent_find_minima(
      [&](double log) { return misfit(sizes, strengths, std::exp(log)); }, low, high, bits);
  SizeEffect fit;
  fit.transition = std::exp(log_transition);
  fit.plastic = best_plastic(sizes, strengths, fit.transition);
  const double mean = spread_of(strengths).mean;
  double total = 0;
  for (const double strength : strengths) total += (strength - mean) * (strength - mean);
  fit.determination = 1 - rest / total;
  fit.bounded = log_transition < low + 0.01 || log_transition > high - 0.01;
  return fit;
}

}  // namespace app
