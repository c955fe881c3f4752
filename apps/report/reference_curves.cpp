#include "apps/report/reference_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace output {
namespace {

constexpr double megapascal = 1e6;

/// Falling branch of GB 50010; its parameter would be negative for the weakest materials.
double falling(double x, double parameter, double exponent) {
  return x / (std::max(0.0, parameter) * std::pow(x - 1, exponent) + x);
}

}  // namespace

double gb_tension(double x, double strength) {
  if (x <= 1) return 1.2 * x - 0.2 * std::pow(x, 6);
  const double f = strength / megapascal;
  return falling(x, 0.312 * f * f, 1.7);
}

double gb_tension_peak_strain(double strength) { return 65e-6 * std::pow(strength / megapascal, 0.54); }

double gb_compression(double x, double strength, double young) {
  const double f = strength / megapascal;
  if (x > 1) return falling(x, 0.157 * std::pow(f, 0.785) - 0.905, 2);
  // y = (1 - d) E e / f with d = 1 - rho n / (n - 1 + x^n) and rho = f / (E e_c)
  const double elastic = young * gb_compression_peak_strain(strength);
  const double n = elastic / (elastic - strength);
  return n * x / (n - 1 + std::pow(x, n));
}

double gb_compression_peak_strain(double strength) {
  return (700 + 172 * std::sqrt(strength / megapascal)) * 1e-6;
}

double en_compression(double x, double strength) {
  const double peak_strain = en_compression_peak_strain(strength);
  if (x * peak_strain > 3.5e-3) return std::numeric_limits<double>::quiet_NaN();
  const double k = 1.05 * en_young(strength) * peak_strain / strength;
  return (k * x - x * x) / (1 + (k - 2) * x);
}

double en_compression_peak_strain(double strength) {
  return std::min(0.7 * std::pow(strength / megapascal, 0.31), 2.8) * 1e-3;
}

double en_young(double strength) { return 22000 * std::pow(strength / megapascal / 10, 0.3) * megapascal; }

double en_compressive_strength(double tensile_strength) {
  const double characteristic = std::pow(tensile_strength / megapascal / 0.3, 1.5);
  return (std::min(characteristic, 50.0) + 8) * megapascal;
}

double hordijk_softening(double opening) {
  return (1 + 27 * std::pow(opening, 3)) * std::exp(-6.93 * opening) - 28 * opening * std::exp(-6.93);
}

double hordijk_last_opening(double fracture_energy, double tensile_strength) {
  return 5.136 * fracture_energy / tensile_strength;
}

double fib_fracture_energy(double compressive_strength) {
  return 73 * std::pow(compressive_strength / megapascal, 0.18);
}

}  // namespace output
