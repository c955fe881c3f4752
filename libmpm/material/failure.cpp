#include "libmpm/material/failure.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/material/softening.hpp"
#include "libmpm/material/strength.hpp"

namespace mpm {
double largest_strain(const Phase& phase, Plane plane, const Stress<double>& elastic) {
  const PrincipalStress s = principal_stress(elastic.xx, elastic.yy, elastic.xy, 0);
  const double nu = plane == Plane::strain ? phase.poisson / (1 - phase.poisson) : phase.poisson;
  return (s.first - nu * s.second) / bar_modulus(phase, plane);
}

namespace {

constexpr double rounding_room = 1e-6;  ///< a few last places of a number in 32 bits [-]

/// The elastic stress less what a crack does not carry.
Stress<double> closed_crack(const Phase& phase, const Stress<double>& elastic, const DamageLaw& law) {
  const double nu = phase.poisson;
  const double lateral = law.plane == Plane::strain ? nu / (1 - nu) : nu;
  return without_tension(elastic, law.closure == CrackClosure::unilateral ? lateral : 0.0);
}

Response cracked_through(const PointState& point, const DamageLaw& law) {
  Response response{point, true, FailureMode::tension};
  PointState& after = response.point;
  after.strength = Phase::unbreakable;
  if (law.closure != CrackClosure::off) {
    after.cracked = 1;
    after.spent = !point.phase->can_shear();
  } else {
    after.kept = law.residual_stiffness;
    after.spent = true;
  }
  return response;
}

Response softened(const PointState& point, const Stress<double>& elastic, const DamageLaw& law) {
  const double peak = tension_threshold(*point.phase, point.factor);
  const double sum = largest_strain(*point.phase, law.plane, elastic);
  const double strain = law.logarithmic ? std::expm1(sum) : sum;  // opening over the width of the band
  const double strength =
      std::min(point.strength, softening(*point.phase, law.plane, peak, law.band).stress_at(strain));
  const bool fails = point.strength > 0.5 * peak && strength <= 0.5 * peak;
  if (strength < exhausted * peak) {
    Response response = cracked_through(point, law);
    if (!fails) response.failure = FailureMode::none;
    return response;
  }
  Response response{point, true, fails ? FailureMode::tension : FailureMode::none};
  response.point.strength = strength;
  const double share = strength / principal_stress(elastic.xx, elastic.yy, elastic.xy, 0).first;
  if (law.closure != CrackClosure::off)  // what shear has left of the stiffness carries less of the stress
    response.point.cracked = std::max(point.cracked, 1 - share / point.kept);
  else
    response.point.kept = std::max(share, law.residual_stiffness);
  return response;
}

/// Largest utilisation that a point has been through, from the stiffness that it has left [-].
double largest_utilisation(const PointState& point, const Softening& curve) {
  return point.kept < 1 ? strain_of_secant(curve, point.kept, curve.onset) : curve.onset;
}

Response crushed(const PointState& point, const DamageLaw& law) {
  Response response{point, true, FailureMode::shear};
  response.point.strength = Phase::unbreakable;
  response.point.kept = std::min(point.kept, law.residual_stiffness);
  response.point.cracked = 0;
  response.point.spent = true;
  return response;
}

/// The shear band of a point goes on along its curve.
/// @param whole  stress that the point would carry with all of its stiffness [Pa].
Response sheared(const PointState& point, const PrincipalStress& whole, const DamageLaw& law) {
  const Softening curve = shear_softening(*point.phase, law.plane, point.factor, law.band);
  const double reached = shear_utilisation(*point.phase, point.factor, whole);
  const double before = largest_utilisation(point, curve);
  if (!(reached > (point.kept < 1 ? 1 + rounding_room : 1) * before)) return {point};
  const double after = curve.stress_at(reached);
  const bool fails = curve.stress_at(before) > 0.5 && after <= 0.5;
  if (after < exhausted) {
    Response response = crushed(point, law);
    if (!fails) response.failure = FailureMode::none;
    return response;
  }
  Response response{point, true, fails ? FailureMode::shear : FailureMode::none};
  response.point.kept = std::max(after / reached, law.residual_stiffness);
  return response;
}

}  // namespace

PointState intact_point(const Phase& phase, double factor) {
  return {.phase = &phase,
          .factor = factor,
          .strength = phase.can_crack() ? tension_threshold(phase, factor) : Phase::unbreakable,
          .spent = !phase.can_fail()};
}

DamageLaw damage_law(const Scene& scene, double band, bool logarithmic) {
  return {scene.plane, scene.damage.crack_closure, scene.damage.residual_stiffness, band, logarithmic};
}

Stress<double> carried_stress(const PointState& point, const Stress<double>& elastic, const DamageLaw& law) {
  Stress<double> s = elastic;
  if (point.cracked > 0) {
    const Stress<double> closed = closed_crack(*point.phase, elastic, law);
    const double whole = 1 - point.cracked;
    s = {whole * s.xx + point.cracked * closed.xx, whole * s.yy + point.cracked * closed.yy,
         whole * s.xy + point.cracked * closed.xy};
  }
  return {point.kept * s.xx, point.kept * s.yy, point.kept * s.xy};
}

Response respond(const PointState& point, const Stress<double>& elastic, const DamageLaw& law) {
  if (point.spent) return {point};
  const Stress<double> s = carried_stress(point, elastic, law);
  const double normal = law.plane == Plane::strain ? point.phase->poisson * (s.xx + s.yy) : 0.0;
  const PrincipalStress principal = principal_stress(s.xx, s.yy, s.xy, normal);
  // A point on its softening curve carries its strength, but for the rounding of what is stored of it:
  // without room for that it would lose a last place in every step, and the more the shorter the steps are.
  const bool softens = point.kept < 1 || (point.cracked > 0 && point.cracked < 1);
  const double room = softens ? 1 + rounding_room : 1;
  if (std::max(principal.first, principal.normal) > room * point.strength)
    return point.phase->softens() ? softened(point, elastic, law) : cracked_through(point, law);
  if (point.phase->softens_in_shear() && law.closure != CrackClosure::off) {
    const double part = 1 / point.kept;
    return sheared(point, {part * principal.first, part * principal.second, part * principal.normal}, law);
  }
  if (fails_in_shear(*point.phase, point.factor, principal)) return crushed(point, law);
  return {point};
}

double remaining_cohesion(const PointState& point, const DamageLaw& law) {
  if (!point.phase->softens_in_shear() || law.closure == CrackClosure::off || !(point.kept < 1)) return 1;
  const Softening curve = shear_softening(*point.phase, law.plane, point.factor, law.band);
  return point.kept > 0 ? curve.stress_at(largest_utilisation(point, curve)) : 0;
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
