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
  // One that was stored before, and came back through its scale, keeps its bits.
  constexpr double way_back = 1 + 1e-15;
  return static_cast<double>(rounded) > way_back * scaled ? std::nextafterf(rounded, 0.0F) : rounded;
}

}  // namespace mpm
