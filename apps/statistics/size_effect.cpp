#include "apps/statistics/size_effect.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "apps/statistics/statistics.hpp"

namespace app {
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
