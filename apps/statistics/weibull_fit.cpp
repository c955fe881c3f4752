#include "apps/statistics/weibull_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

#include "apps/statistics/statistics.hpp"

namespace app {
namespace {

/// Derivative of the likelihood by the modulus, over the number of values; falls from +infinity.
/// @param logs  of the values over the largest one.
double likelihood_slope(const std::vector<double>& logs, double modulus) {
  double powers = 0, weighted = 0, sum = 0;
  for (const double log : logs) {
    const double power = std::exp(modulus * log);
    powers += power;
    weighted += power * log;
    sum += log;
  }
  return 1 / modulus + sum / static_cast<double>(logs.size()) - weighted / powers;
}

double root_of_slope(const std::vector<double>& logs) {
  std::uintmax_t steps = 200;
  const auto slope = [&](double modulus) { return likelihood_slope(logs, modulus); };
  const auto [low, high] = boost::math::tools::bracket_and_solve_root(
      slope, 1.0, 2.0, false, boost::math::tools::eps_tolerance<double>(48), steps);
  return 0.5 * (low + high);
}

}  // namespace

double weibull_distribution(double x, double scale, double modulus) {
  return -std::expm1(-std::pow(x / scale, modulus));
}

double weibull_density(double x, double scale, double modulus) {
  return modulus / scale * std::pow(x / scale, modulus - 1) * std::exp(-std::pow(x / scale, modulus));
}

double largest_distance(std::vector<double> values, const std::function<double(double)>& distribution) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = distribution(values[i]);
    const auto below = static_cast<double>(i);  // the empirical distribution steps from below / count up
    largest = std::max({largest, share - below / count, (below + 1) / count - share});
  }
  return largest;
}

double critical_distance(std::size_t count) { return 1.358 / std::sqrt(static_cast<double>(count)); }

double WeibullFit::quantile(double p) const { return scale * std::pow(-std::log1p(-p), 1 / modulus); }

double WeibullFit::log_error(double p) const {
  const double w = std::log(-std::log1p(-p));
  return std::sqrt((1.1087 - 0.5140 * w + 0.6079 * w * w) / static_cast<double>(count)) / modulus;
}

double WeibullFit::modulus_error() const { return std::sqrt(0.6079 / static_cast<double>(count)); }

WeibullFit fit_weibull(const std::vector<double>& values) {
  WeibullFit fit{no_number, no_number, values.size()};
  if (values.empty()) return fit;
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  if (!(*least < *largest)) return fit;
  std::vector<double> logs;
  for (const double value : values) logs.push_back(std::log(value / *largest));
  fit.modulus = root_of_slope(logs);
  double powers = 0;
  for (const double log : logs) powers += std::exp(fit.modulus * log);
  fit.scale = *largest * std::pow(powers / static_cast<double>(values.size()), 1 / fit.modulus);
  return fit;
}

std::vector<double> histogram(const std::vector<double>& values, double end, int bins) {
  std::vector<double> density(static_cast<std::size_t>(bins), 0.0);
  const double width = end / bins;
  for (const double value : values)
    if (value >= 0 && value < end)
      density[std::min(density.size() - 1, static_cast<std::size_t>(value / width))] +=
          1 / (width * static_cast<double>(values.size()));
  return density;
}

}  // namespace app
