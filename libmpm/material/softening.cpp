#include "libmpm/material/softening.hpp"

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

namespace {

constexpr double tooth_ratio = 0.9;  ///< of the stiffness of a tooth to that of the one before [-]

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

/// What the curve has dissipated when it unloads from a strain [J/m^3].
double dissipated(const Softening& curve, double strain) {
  const double stress = curve.stress_at(strain);
  return 0.5 * curve.peak * curve.onset + curve.area_to(strain) - 0.5 * stress * strain;
}

}  // namespace

/// Of an exponential by Newton's method: the logarithm of the equation is concave, so that no step
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

}  // namespace mpm
