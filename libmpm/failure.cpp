#include "libmpm/failure.hpp"

#include "libmpm/strength.hpp"

namespace mpm {

Stress<double> carried_stress(const PointState& point, const Stress<double>& elastic, Plane plane) {
  const double nu = point.phase->poisson;
  switch (point.crack) {
    case CrackClosure::off:
      break;
    case CrackClosure::clipped:
      return without_tension(elastic, 0.0);
    case CrackClosure::unilateral:
      return without_tension(elastic, plane == Plane::strain ? nu / (1 - nu) : nu);
  }
  return elastic;
}

FailureMode judge(const PointState& point, const Stress<double>& elastic, Plane plane) {
  const Stress<double> s = carried_stress(point, elastic, plane);
  const double normal = plane == Plane::strain ? point.phase->poisson * (s.xx + s.yy) : 0.0;
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, normal);
  if (point.crack == CrackClosure::off && fails_in_tension(*point.phase, point.factor, principal))
    return FailureMode::tension;
  return fails_in_shear(*point.phase, point.factor, principal) ? FailureMode::shear : FailureMode::none;
}

double stress_power(const Phase& phase, Plane plane, const Stress<double>& stress,
                    const Stress<double>& elastic) {
  const double nu = plane == Plane::strain ? phase.poisson / (1 - phase.poisson) : phase.poisson;
  const double young =
      plane == Plane::strain ? phase.young / (1 - phase.poisson * phase.poisson) : phase.young;
  const double exx = (elastic.xx - nu * elastic.yy) / young;
  const double eyy = (elastic.yy - nu * elastic.xx) / young;
  const double gxy = elastic.xy * 2 * (1 + phase.poisson) / phase.young;
  return stress.xx * exx + stress.yy * eyy + stress.xy * gxy;
}

}  // namespace mpm
