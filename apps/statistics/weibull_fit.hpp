/// Whether strengths follow the Weibull distribution.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

/// Share of points that are weaker than x [-], and its derivative; x and scale in one unit, x >= 0.
[[nodiscard]] double weibull_distribution(double x, double scale, double modulus);
[[nodiscard]] double weibull_density(double x, double scale, double modulus);  ///< per unit of x

/// Largest distance between the distribution of the values and a given one [-], by Kolmogorov and Smirnov.
/// @pre at least one value.
[[nodiscard]] double largest_distance(std::vector<double> values,
                                      const std::function<double(double)>& distribution);

/// Distance [-] that `count` values of the given distribution exceed in 5 of 100 samples.
/// Source: the limit for many values, 1.358 / sqrt(n).
[[nodiscard]] double critical_distance(std::size_t count);

/// Distribution that fits a sample best: the parameters of maximum likelihood.
struct WeibullFit {
  double scale = 0;
  double modulus = 0;
  std::size_t count = 0;  ///< of the sample

  /// Value below which a share p in (0, 1) lies.
  [[nodiscard]] double quantile(double p) const;
  /// Standard error of the logarithm of that value [-]: sqrt((1.1087 - 0.5140 w + 0.6079 w^2) / n) / modulus
  /// with w = ln(-ln(1 - p)); for many values, about 20 and more.
  /// Source: asymptotic covariance of the estimates, Lawless (2003), Statistical Models and Methods for
  /// Lifetime Data, 2nd ed.
  [[nodiscard]] double log_error(double p) const;
  /// Standard error of the modulus over the modulus [-]: sqrt(0.6079 / n).
  [[nodiscard]] double modulus_error() const;
};

/// @return scale and modulus NaN for fewer than two different values.   @pre positive values.
[[nodiscard]] WeibullFit fit_weibull(const std::vector<double>& values);

/// Density of values in equal bins from 0 to end; values beyond count in the whole but have no bin.
[[nodiscard]] std::vector<double> histogram(const std::vector<double>& values, double end, int bins);

}  // namespace app
