#include "apps/report/reference_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/drawing/ticks.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"

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

namespace {

constexpr int places = 200;

/// A curve, stress [Pa] of strain [-], from rest to the end of the run.
template <class Stress>
Series sampled(const RunRecord& record, const std::string& name, Ink ink, Stress&& stress) {
  const double per_strain = strain_unit(record.result).per_strain;
  const double end = largest_strain(record.result);
  Series series{name, {}, {}, ink, true};
  for (int i = 0; i <= places; ++i) {
    const double strain = end * i / places;
    series.x.push_back(per_strain * strain);
    series.y.push_back(1e-6 * stress(strain));
  }
  return series;
}

std::vector<Series> in_tension(const RunRecord& record, double strength) {
  const double height = record.specimen.mask.height();
  const double young = secant_modulus(record.result);
  const double last = hordijk_last_opening(fib_fracture_energy(en_compressive_strength(strength)), strength);
  // Behind the peak one crack opens, and what is beside it unloads: strain = s / E + opening / height. The
  // opening of a strain by bisection.
  const auto softening = [=](double strain) {
    if (strain * young <= strength) return strain * young;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const double reached = strength * hordijk_softening(middle) / young + middle * last / height;
      (reached < strain ? low : high) = middle;
    }
    return strength * hordijk_softening(low);
  };
  std::vector<Series> series{sampled(record, "GB 50010", Ink::second, [=](double strain) {
    return strength * gb_tension(strain / gb_tension_peak_strain(strength), strength);
  })};
  if (young > 0) series.push_back(sampled(record, "Hordijk", Ink::third, softening));
  return series;
}

std::vector<Series> in_compression(const RunRecord& record, double strength) {
  const double young = secant_modulus(record.result);
  std::vector<Series> series;
  // The code's own peak strain asks for a modulus above the secant one at the peak.
  if (young * gb_compression_peak_strain(strength) > strength)
    series.push_back(sampled(record, "GB 50010", Ink::second, [=](double strain) {
      return strength * gb_compression(strain / gb_compression_peak_strain(strength), strength, young);
    }));
  series.push_back(sampled(record, "EN 1992-1-1", Ink::third, [=](double strain) {
    return strength * en_compression(strain / en_compression_peak_strain(strength), strength);
  }));
  return series;
}

}  // namespace

std::vector<Series> reference_series(const RunRecord& record) {
  if (record.scene.fixture.has_loads()) return {};
  const double strength = record.result.peak_stress;
  if (!has_platens(record.scene) || !mpm::peak_reached(record.result) || record.result.history.size() < 2)
    return {};
  return record.scene.loading.direction == mpm::Direction::tension ? in_tension(record, strength)
                                                                   : in_compression(record, strength);
}

}  // namespace output
