/// What a stress does to a material point: the exact decision on a point that the fast test suspects.
#pragma once

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/material/stress.hpp"

namespace mpm {

/// A material point as the decision sees it.
struct PointState {
  const Phase* phase = nullptr;
  double factor = 1;                     ///< on its strength [-]
  double strength = Phase::unbreakable;  ///< largest principal stress that it carries [Pa]; infinite for a
                                         ///< point that does not crack, or has cracked through
  double kept = 1;                       ///< share of its stiffness that it still has [-]
  double cracked = 0;  ///< with crack closure: share of its resistance to tension that it has lost [-]
  bool spent = false;  ///< nothing can happen to it any more
};
[[nodiscard]] PointState intact_point(const Phase& phase, double factor);

/// What all points of a run obey.
struct DamageLaw {
  Plane plane = Plane::strain;
  CrackClosure closure = CrackClosure::off;
  double residual_stiffness = 0;  ///< [-]
  double band = 0;                ///< width of a crack band [m]
  bool logarithmic = false;       ///< strains are sums of rates, as of moving points
};
/// @param band  width of a crack band [m].
[[nodiscard]] DamageLaw damage_law(const Scene& scene, double band, bool logarithmic);

/// Stress that the point carries where an intact one would carry `elastic` [Pa].
[[nodiscard]] Stress<double> carried_stress(const PointState& point, const Stress<double>& elastic,
                                            const DamageLaw& law);

/// What becomes of a point.
struct Response {
  PointState point;  ///< afterwards
  bool changed = false;
  FailureMode failure = FailureMode::none;  ///< that happened just now; a point that softens fails in tension
                                            ///< when half of its strength is lost, and with it about half of
                                            ///< its fracture energy
};
/// What a point does under an elastic stress [Pa]; tension is tested first.
[[nodiscard]] Response respond(const PointState& point, const Stress<double>& elastic, const DamageLaw& law);

/// Product of a stress with the strain that belongs to the elastic stress `elastic` [J/m^3].
[[nodiscard]] double stress_power(const Phase& phase, Plane plane, const Stress<double>& stress,
                                  const Stress<double>& elastic);

}  // namespace mpm
