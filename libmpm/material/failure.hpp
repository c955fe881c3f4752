/// Failure of a material point under a stress: the exact criteria for a point that the fast test suspects.
#pragma once

#include "libmpm/material/stress.hpp"
#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Largest principal strain in the plane for an elastic stress [-].
[[nodiscard]] double largest_strain(const Phase& phase, Plane plane, const Stress<double>& elastic);

/// State of a material point for the failure criteria.
struct PointState {
  const Phase* phase = nullptr;
  double factor = 1;                     ///< strength factor q [-]
  double strength = Phase::unbreakable;  ///< largest principal stress that it carries [Pa]; infinite for a
                                         ///< point that does not crack, or has cracked through
  double kept = 1;                       ///< share of its stiffness that remains [-]
  double cracked = 0;  ///< with crack closure: share of its tensile strength that is lost [-]
  bool spent = false;  ///< it cannot change any more
};
[[nodiscard]] PointState intact_point(const Phase& phase, double factor);

/// Rules for all points of a run.
struct DamageLaw {
  Plane plane = Plane::strain;
  CrackClosure closure = CrackClosure::off;
  double residual_stiffness = 0;  ///< [-]
  double band = 0;                ///< width of a crack band [m]
  bool logarithmic = false;       ///< strains are sums of rates, as of moving points
};
/// @param band  width of a crack band [m].
[[nodiscard]] DamageLaw damage_law(const Scene& scene, double band, bool logarithmic);

/// Share of the cohesion that remains of a point [-].
[[nodiscard]] double remaining_cohesion(const PointState& point, const DamageLaw& law);

/// Stress [Pa] of the point if an intact point would carry `elastic` [Pa].
[[nodiscard]] Stress<double> carried_stress(const PointState& point, const Stress<double>& elastic,
                                            const DamageLaw& law);

/// Result of the failure criteria.
struct Response {
  PointState point;  ///< afterwards
  bool changed = false;
  FailureMode failure = FailureMode::none;  ///< that happened just now; a point that softens fails when half
                                            ///< of its strength is lost, and with it about half of its
                                            ///< fracture energy
};
/// Apply the failure criteria to a point under an elastic stress [Pa]; tension is tested first.
[[nodiscard]] Response respond(const PointState& point, const Stress<double>& elastic, const DamageLaw& law);

/// Product of a stress with the strain of the elastic stress `elastic` [J/m^3].
[[nodiscard]] double stress_power(const Phase& phase, Plane plane, const Stress<double>& stress,
                                  const Stress<double>& elastic);

}  // namespace mpm
