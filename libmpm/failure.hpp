/// The exact decision on a point that the fast test suspects.
#pragma once

#include "libmpm/phase.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene.hpp"
#include "libmpm/stress.hpp"

namespace mpm {

/// A material point as the decision sees it.
struct PointState {
  const Phase* phase = nullptr;
  double factor = 1;                       ///< on its strength [-]
  CrackClosure crack = CrackClosure::off;  ///< the law of a point that failed in tension before; off = intact
};

/// Stress that the point carries where an intact one would carry `elastic` [Pa].
[[nodiscard]] Stress<double> carried_stress(const PointState& point, const Stress<double>& elastic,
                                            Plane plane);

/// What a point of the state does under an elastic stress [Pa]; tension is tested first.
[[nodiscard]] FailureMode judge(const PointState& point, const Stress<double>& elastic, Plane plane);

/// Product of a stress with the strain that belongs to the elastic stress `elastic` [J/m^3].
[[nodiscard]] double stress_power(const Phase& phase, Plane plane, const Stress<double>& stress,
                                  const Stress<double>& elastic);

}  // namespace mpm
