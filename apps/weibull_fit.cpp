#include "apps/weibull_fit.hpp"

#include <algorithm>
#include <cmath>

namespace app {

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
