/// Figures about a number of runs, and how well they are known.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace app {

/// Where there is nothing to tell.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Of finite values; NaN where there are none.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< standard deviation of a sample; 0 for a single value
  double low = 0;
  double high = 0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// Spearman's rank correlation [-], -1 ... 1: 1 = y rises whenever x does. NaN for fewer than two pairs or
/// where a value is not finite; values that occur twice share their rank.   @pre x and y have one length.
[[nodiscard]] double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

/// Exponent p of the power law y ~ x^p that fits best in logarithms [-].   @pre positive x, y of one length.
[[nodiscard]] double power_of(const std::vector<double>& x, const std::vector<double>& y);

/// Share of the values in [low, high] [-]; NaN for no value.
[[nodiscard]] double share_within(const std::vector<double>& values, double low, double high);

/// Value below which a share p of the values lies, between two of them by a straight line; NaN for none.
/// Source: Hyndman and Fan (1996), definition 7.   @pre finite values, p in [0, 1].
[[nodiscard]] double quantile_of(std::vector<double> values, double p);

/// The finite values.
[[nodiscard]] std::vector<double> finite_of(const std::vector<double>& values);

/// Mean of a sample with the 95 % confidence interval of Student's t: mean - half_width ... mean +
/// half_width.
struct MeanEstimate {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;   ///< standard deviation of the sample
  double half_width = 0;  ///< NaN for fewer than two values

  [[nodiscard]] double relative_half_width() const;  ///< over the mean's amount [-]
};

/// Of the finite values; NaN where there are none.
[[nodiscard]] MeanEstimate mean_estimate(const std::vector<double>& values);

/// Number of values that bring the half width of the interval within a share of the mean, if they scatter as
/// those of the sample; at least 2.   @param share  [-], > 0.   @return 0 where it cannot be told.
[[nodiscard]] std::size_t values_needed(const MeanEstimate& estimate, double share);

}  // namespace app
