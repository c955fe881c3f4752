#include "apps/command/doctor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "apps/system/machine.hpp"
#include "libmpm/run/simulate.hpp"

namespace app {
namespace {

constexpr double pixel = 0.5e-3;               // [m]
constexpr double known_peak = 4.0162525577e6;  // [Pa], of cracking_block() with each of the instruction sets

enum Label : std::uint8_t { aggregate = 1, mortar = 2, itz = 3 };

mpm::Scene block(int rows, int cols) {
  mpm::Scene scene;
  scene.labels.setConstant(rows, cols, mortar);
  scene.pixel_size = pixel;
  scene.phases = {std::nullopt};
  for (const mpm::Phase& phase : mpm::concrete_phases()) scene.phases.emplace_back(phase);
  return scene;
}

/// Mortar without cracks, pulled so slowly that its waves are below a thousandth.
mpm::Scene elastic_block() {
  mpm::Scene scene = block(40, 40);
  mpm::Phase& phase = *scene.phases[mortar];
  phase.tensile_scale = phase.cohesion = mpm::Phase::unbreakable;
  scene.loading.velocity = 0.02;
  scene.loading.stop_strain = 2e-4;
  scene.local_damping = 0.5;
  return scene;
}

/// Round aggregates with their ITZ in rows, pulled until the stress has passed its peak.
mpm::Scene cracking_block() {
  constexpr int edge = 160, pitch = 20;
  constexpr double middle = 0.5 * (pitch - 1);  // [px]
  mpm::Scene scene = block(edge, edge);
  for (int row = 0; row < edge; ++row)
    for (int col = 0; col < edge; ++col) {
      const int shift = row / pitch % 2 * pitch / 2;
      const double distance = std::hypot(row % pitch - middle, (col + shift) % pitch - middle);
      if (distance < 8.2) scene.labels(row, col) = distance < 7 ? aggregate : itz;
    }
  scene.loading.velocity = 0.2;
  scene.loading.stop_strain = 3e-4;
  scene.history_rows = 100;
  scene.cfl = 0.8;
  return scene;
}

double modulus_error() {
  const mpm::Scene scene = elastic_block();
  const mpm::HistoryRow last = mpm::simulate(scene).history.back();
  const mpm::Phase& phase = *scene.phases[mortar];
  const double known = phase.young / (1 - phase.poisson * phase.poisson);
  return std::abs(last.stress / last.strain / known - 1);
}

mpm::Result crack(int threads) {
  mpm::Scene scene = cracking_block();
  scene.threads = threads;
  return mpm::simulate(scene);
}

bool same_bits(const mpm::Result& a, const mpm::Result& b) {
  const auto bytes = [](const auto& map) { return static_cast<std::size_t>(map.size()) * sizeof(float); };
  return a.peak_stress == b.peak_stress && a.history.size() == b.history.size() &&
         std::equal(
             a.history.begin(), a.history.end(), b.history.begin(),
             [](const auto& x, const auto& y) { return x.stress == y.stress && x.elastic == y.elastic; }) &&
         bytes(a.failure_strain) == bytes(b.failure_strain) &&
         std::memcmp(a.failure_strain.data(), b.failure_strain.data(), bytes(a.failure_strain)) == 0;
}

}  // namespace

SelfTest run_self_test(int threads) {
  SelfTest test;
  test.threads = threads;
  test.modulus_error = modulus_error();
  const mpm::Result alone = crack(1);
  test.peak_error = std::abs(alone.peak_stress / known_peak - 1);
  test.same_on_threads = same_bits(alone, crack(threads));
  test.updates_per_second = alone.point_updates_per_second();
  test.share_of_peak = test.updates_per_second * lattice_operations / measure_flops_double();
  return test;
}

}  // namespace app
