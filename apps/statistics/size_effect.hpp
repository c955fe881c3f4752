/// Strength against size.
#pragma once

#include <vector>

namespace app {

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
