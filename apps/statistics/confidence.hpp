/// How well a mean is known from a number of runs.
#pragma once

#include <cstddef>
#include <vector>

namespace app {

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
