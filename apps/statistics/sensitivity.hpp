/// Which parameters a result depends on, told from runs at given points.
#pragma once

#include <cstddef>
#include <vector>

namespace app {

/// Probability that values without any dependence have a rank correlation of at least this amount (Student's
/// t with n - 2 degrees of freedom) [-]; NaN for fewer than four pairs or without a correlation.
[[nodiscard]] double significance_of(double rank_correlation, std::size_t count);

/// First-order index of Sobol [-]: the share of the variance of y that x explains on its own, from the
/// spread of y within classes of x: those of equal x where there are few, else about sqrt(n) of equal size.
/// The bias of finite classes is taken off, so that an x without influence has an index around 0, which may
/// be negative. NaN where y does not vary, or no class has two values.
/// Source: Plischke, Borgonovo, Smith (2013), Global sensitivity measures from given data; the correction is
/// that of Kelley (1935).   @pre finite x, y of one length.
[[nodiscard]] double first_order_index(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace app
