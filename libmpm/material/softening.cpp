#include "libmpm/material/softening.hpp"

#include <cmath>

#include "libmpm/material/strength.hpp"

namespace mpm {
namespace {

/// Stress over strain of a bar that is free sideways in the plane [Pa].
double bar_modulus(const Phase& phase, Plane plane) {
  return plane == Plane::strain ? phase.young / (1 - phase.poisson * phase.poisson) : phase.young;
}

}  // namespace

double Softening::stress_at(double strain) const {
  return strain > onset ? peak * std::exp(-(strain - onset) / scale) : peak;
}

Softening softening(const Phase& phase, Plane plane, double peak, double band) {
  const double onset = peak / bar_modulus(phase, plane);
  // Area under the curve: peak onset / 2 + peak scale = fracture energy / band.
  return {peak, onset, phase.fracture_energy / (band * peak) - 0.5 * onset};
}

double widest_band(const Phase& phase, Plane plane, double peak) {
  return 2 * bar_modulus(phase, plane) * phase.fracture_energy / (peak * peak);
}

double largest_strain(const Phase& phase, Plane plane, const Stress<double>& elastic) {
  const PrincipalStress s = principal_stress(elastic.xx, elastic.yy, elastic.xy, 0);
  const double nu = plane == Plane::strain ? phase.poisson / (1 - phase.poisson) : phase.poisson;
  return (s.first - nu * s.second) / bar_modulus(phase, plane);
}

}  // namespace mpm
