/// Thresholds in the form that the kernels compare.
#pragma once

#include <cmath>

#include "libmpm/kernels/lattice_kernels.hpp"

namespace mpm {

/// Threshold as stored for the sweeps: never above the true one, so that no failure is missed.
/// @param stress  [Pa].   @param scale  from a stress to the measure of the sweeps.
[[nodiscard]] inline float stored_threshold(double stress, double scale) {
  const double scaled = stress * scale;
  if (!(scaled < static_cast<double>(kernels::unreachable))) return kernels::unreachable;
  const auto rounded = static_cast<float>(scaled);
  return static_cast<double>(rounded) > scaled ? std::nextafterf(rounded, 0.0F) : rounded;
}

}  // namespace mpm
