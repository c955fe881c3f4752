/// Whether strengths follow the Weibull distribution.
#pragma once

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

/// Density of values in equal bins from 0 to end; values beyond count in the whole but have no bin.
[[nodiscard]] std::vector<double> histogram(const std::vector<double>& values, double end, int bins);

}  // namespace app
