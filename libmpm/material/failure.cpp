#include "libmpm/material/failure.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/material/strength.hpp"

namespace mpm {
namespace {

constexpr double bend = 0.8, height_of_bend = 1.0 / 3, end_of_lines = 3.6;
constexpr double hordijk_cube = 27, hordijk_decay = 6.93;  ///< c1^3, c2
/// Last opening over that at which the peak would have spent the energy: such that the area is 1.
constexpr double hordijk_end = 5.136;

/// Stress over the peak.
double hordijk(double y) {
  if (y >= 1) return 0;
  return (1 + hordijk_cube * y * y * y) * std::exp(-hordijk_decay * y) -
         y * (1 + hordijk_cube) * std::exp(-hordijk_decay);
}

/// Integral of that from 0.
double area_of_hordijk(double y) {
  y = std::min(y, 1.0);
  const double c = hordijk_decay;
  const double cubic = y * y * y / c + 3 * y * y / (c * c) + 6 * y / (c * c * c) + 6 / (c * c * c * c);
  return (1 - std::exp(-c * y)) / c + hordijk_cube * (6 / (c * c * c * c) - cubic * std::exp(-c * y)) -
         0.5 * y * y * (1 + hordijk_cube) * std::exp(-c);
}

double two_lines(double x) {
  if (x < bend) return 1 - (1 - height_of_bend) * x / bend;
  return x < end_of_lines ? height_of_bend * (end_of_lines - x) / (end_of_lines - bend) : 0;
}

double area_of_two_lines(double x) {
  if (x < bend) return x * (1 - 0.5 * (1 - height_of_bend) * x / bend);
  const double rest = std::max(end_of_lines - x, 0.0);
  return 1 - 0.5 * height_of_bend * rest * rest / (end_of_lines - bend);
}

}  // namespace

double Softening::stress_at(double strain) const {
  if (!(strain > onset)) return peak;
  const double x = (strain - onset) / scale;
  switch (curve) {
    case SofteningCurve::exponential:
      break;
    case SofteningCurve::bilinear:
      return peak * two_lines(x);
    case SofteningCurve::hordijk:
      return peak * hordijk(x / hordijk_end);
  }
  return peak * std::exp(-(strain - onset) / scale);
}

double Softening::area_to(double strain) const {
  const double x = (strain - onset) / scale;
  switch (curve) {
    case SofteningCurve::exponential:
      break;
    case SofteningCurve::bilinear:
      return peak * scale * area_of_two_lines(x);
    case SofteningCurve::hordijk:
      return peak * scale * hordijk_end * area_of_hordijk(x / hordijk_end);
  }
  return (peak - stress_at(strain)) * scale;
}

Softening softening(const Phase& phase, Plane plane, double peak, double band) {
  const double onset = peak / bar_modulus(phase, plane);
  // Area under the curve: peak onset / 2 + peak scale = fracture energy / band.
  return {peak, onset, phase.fracture_energy / (band * peak) - 0.5 * onset, phase.softening};
}

double widest_band(const Phase& phase, Plane plane, double peak) {
  return 2 * bar_modulus(phase, plane) * phase.fracture_energy / (peak * peak);
}

Softening shear_softening(const Phase& phase, Plane plane, double factor, double band) {
  const double strength = compressive_strength(phase, factor);
  return {1, 1, phase.shear_fracture_energy * bar_modulus(phase, plane) / (band * strength * strength) - 0.5};
}

double widest_shear_band(const Phase& phase, Plane plane, double factor) {
  const double strength = compressive_strength(phase, factor);
  return 2 * bar_modulus(phase, plane) * phase.shear_fracture_energy / (strength * strength);
}

double largest_strain(const Phase& phase, Plane plane, const Stress<double>& elastic) {
  const PrincipalStress s = principal_stress(elastic.xx, elastic.yy, elastic.xy, 0);
  const double nu = plane == Plane::strain ? phase.poisson / (1 - phase.poisson) : phase.poisson;
  return (s.first - nu * s.second) / bar_modulus(phase, plane);
}

namespace {

/// Share of its first strength below which a softening point is taken to be cracked through.
constexpr double exhausted = 1e-3;
constexpr double rounding_room = 1e-6;  ///< a few last places of a number in 32 bits [-]
constexpr double tooth_ratio = 0.9;     ///< of the stiffness of a tooth to that of the one before [-]

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

/// Strain at which the secant of a falling curve is this share of the elastic stiffness [-], by bisection
/// from a smaller strain.
double strain_of_any_secant(const Softening& curve, double kept, double strain) {
  const auto is_above = [&](double at) { return curve.stress_at(at) * curve.onset > kept * curve.peak * at; };
  double step = curve.onset;
  double high = strain + step;
  for (; is_above(high); high += step *= 2) strain = high;
  while (true) {
    const double middle = 0.5 * (strain + high);
    if (!(middle > strain && middle < high)) return high;
    (is_above(middle) ? strain : high) = middle;
  }
}

/// The same; of an exponential by Newton's method: the logarithm of the equation is concave, so that no step
/// goes too far.
double strain_of_secant(const Softening& curve, double kept, double strain) {
  if (curve.curve != SofteningCurve::exponential) return strain_of_any_secant(curve, kept, strain);
  for (int i = 0; i < 30; ++i) {
    const double step = (std::log(kept * strain / curve.onset) + (strain - curve.onset) / curve.scale) /
                        (1 / strain + 1 / curve.scale);
    strain -= step;
    if (std::abs(step) < 1e-14 * strain) break;
  }
  return strain;
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

/// What the curve has dissipated when it unloads from a strain [J/m^3].
double dissipated(const Softening& curve, double strain) {
  const double stress = curve.stress_at(strain);
  return 0.5 * curve.peak * curve.onset + curve.area_to(strain) - 0.5 * stress * strain;
}

}  // namespace

Tooth next_tooth(const Softening& curve, double kept, double elastic) {
  const double young = curve.peak / curve.onset;
  const double reached = elastic / young;
  Tooth tooth{1, curve.peak};
  double next = tooth_ratio;
  double secant = strain_of_secant(curve, next, curve.onset);  // where the curve has it
  double released = 0;
  while (true) {
    const double fall = tooth.strength / (tooth.kept * young);  // strain at which this tooth ends
    if (tooth.kept < 0.999 * kept && fall > reached) return tooth;
    if (curve.stress_at(secant) < exhausted * curve.peak) return {};
    released += 0.5 * (tooth.kept - next) * young * fall * fall;
    const double after = tooth_ratio * next;
    secant = strain_of_secant(curve, after, secant);
    const double due = std::max(dissipated(curve, secant) - released, 0.0);
    tooth = {next, std::min(curve.peak, next * std::sqrt(2 * due * young / (next - after)))};
    next = after;
  }
}

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
