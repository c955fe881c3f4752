#include "apps/report/reference_series.hpp"

#include <cmath>
#include <limits>

#include "apps/report/key_figures.hpp"
#include "apps/report/load_words.hpp"
#include "apps/report/reference_curves.hpp"
#include "apps/drawing/strain_unit.hpp"

namespace output {
namespace {

constexpr int places = 200;

/// A curve, stress [Pa] of strain [-], from rest to the end of the run.
template <class Stress>
Series sampled(const RunRecord& record, const std::string& name, Ink ink, Stress&& stress) {
  const double per_strain = strain_unit(record.result).per_strain;
  const double end = record.result.history.back().strain;
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
  const double strength = record.result.peak_stress;
  if (!has_platens(record.scene) || !(strength > 0) || record.result.history.size() < 2) return {};
  return record.scene.loading.direction == mpm::Direction::tension ? in_tension(record, strength)
                                                                   : in_compression(record, strength);
}

}  // namespace output
