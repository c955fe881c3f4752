#include "libmpm/failure.hpp"

#include "libmpm/strength.hpp"

namespace mpm {

FailureMode judge(const PointState& point, const Stress<double>& elastic, Plane plane) {
  const Stress<double> s = point.cracked ? without_tension(elastic) : elastic;
  const double normal = plane == Plane::strain ? point.phase->poisson * (s.xx + s.yy) : 0.0;
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, normal);
  if (!point.cracked && fails_in_tension(*point.phase, point.factor, principal)) return FailureMode::tension;
  return fails_in_shear(*point.phase, point.factor, principal) ? FailureMode::shear : FailureMode::none;
}

double energy_density(const Phase& phase, Plane plane, const Stress<double>& stress,
                      const Stress<double>& elastic) {
  const double nu = plane == Plane::strain ? phase.poisson / (1 - phase.poisson) : phase.poisson;
  const double young =
      plane == Plane::strain ? phase.young / (1 - phase.poisson * phase.poisson) : phase.young;
  const double exx = (elastic.xx - nu * elastic.yy) / young;
  const double eyy = (elastic.yy - nu * elastic.xx) / young;
  const double gxy = elastic.xy * 2 * (1 + phase.poisson) / phase.young;
  return 0.5 * (stress.xx * exx + stress.yy * eyy + stress.xy * gxy);
}

}  // namespace mpm
