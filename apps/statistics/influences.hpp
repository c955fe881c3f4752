/// Which parameters a result depends on, the size among them, told from runs at given points.
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

/// Law of the size effect, strength = plastic / sqrt(1 + size / transition).
/// Source: Bazant (1984), Size effect in blunt fracture: concrete, rock, metal.
struct SizeEffect {
  double plastic = 0;        ///< strength of small specimens, B f_t [Pa]
  double transition = 0;     ///< size D_0 at which plasticity gives way to fracture [m]
  double determination = 0;  ///< share of the variance of the strengths that the law explains, R^2 [-]
  bool bounded = false;  ///< the best transition lies beyond the sizes by a factor of 100: the data do not
                         ///< show where it is

  [[nodiscard]] double strength(double size) const;  ///< [Pa]
};

/// Fit by least squares of the strengths.
/// @param sizes  [m], > 0, at least two different ones.   @param strengths  [Pa], of the same length.
[[nodiscard]] SizeEffect fit_size_effect(const std::vector<double>& sizes,
                                         const std::vector<double>& strengths);

}  // namespace app
