/// Figures about a handful of runs.
#pragma once

#include <vector>

namespace app {

/// Of finite values; NaN where there are none.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of a sample; 0 for a single value
  double low = 0;
  double high = 0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// Spearman's rank correlation [-], -1 ... 1: 1 = y rises whenever x does. NaN for fewer than two pairs or
/// where a value is not finite.   @pre x and y have one length; no value occurs twice in x.
[[nodiscard]] double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

/// Exponent p of the power law y ~ x^p that fits best in logarithms [-].   @pre positive x, y of one length.
[[nodiscard]] double power_of(const std::vector<double>& x, const std::vector<double>& y);

/// Share of the values in [low, high] [-]; NaN for no value.
[[nodiscard]] double share_within(const std::vector<double>& values, double low, double high);

}  // namespace app
