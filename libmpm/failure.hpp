/// The exact decision on a point that the fast test suspects.
#pragma once

#include "libmpm/phase.hpp"
#include "libmpm/result.hpp"
#include "libmpm/stress.hpp"

namespace mpm {

/// A material point as the decision sees it.
struct PointState {
  const Phase* phase = nullptr;
  double factor = 1;     ///< on its strength [-]
  bool cracked = false;  ///< failed in tension before and carries compression only
};

/// What a point of the state does under an elastic stress [Pa]; tension is tested first.
[[nodiscard]] FailureMode judge(const PointState& point, const Stress<double>& elastic, Plane plane);

/// Elastic energy of a stress at the strain that belongs to `elastic` [J/m^3].
[[nodiscard]] double energy_density(const Phase& phase, Plane plane, const Stress<double>& stress,
                                    const Stress<double>& elastic);

}  // namespace mpm
