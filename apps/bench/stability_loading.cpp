// Speed and ramp of the platen at their extremes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability_scenes.hpp"

namespace app::bench {
namespace {

Finding slow() {
  mpm::Scene scene = block(20, 20, elastic());
  scene.loading.velocity = 1e-4;
  scene.loading.stop_strain = 1e-4;
  const mpm::Result whole = mpm::simulate(scene);
  mpm::Scene breaking = concrete(20, 20);
  breaking.loading.velocity = 1e-4;
  const mpm::Result broken = mpm::simulate(breaking);
  const double kinetic = whole.history.back().kinetic / whole.history.back().platen_work;
  return Judge()
      .near("modulus", end_modulus(whole), plane_modulus(*scene.phases[first]), 1e-3)
      .below("kinetic energy over work", kinetic, 1e-6)
      .must(broken.tension_failures > 50, fmt::format("of concrete {} points fail", broken.tension_failures))
      .below("ledger off by", std::max(whole.energy_error, broken.energy_error), 1e-9)
      .finding();
}

/// A bar whose head is set in motion at once; nu = 0, so that waves are plane.
mpm::Scene struck_bar(double velocity, double transits) {
  mpm::Scene scene = block(160, 4, elastic(20e9, 0));
  scene.loading.velocity = velocity;
  scene.loading.ramp_time = 0;
  scene.loading.stop_strain = transits * velocity / std::sqrt(20e9 / 2400);
  scene.history_rows = 4000;
  return scene;
}

/// rho c v behind the front, and nothing ahead of it.
Finding fast() {
  const double velocity = 100;
  const mpm::Scene scene = struck_bar(velocity, 0.9);
  const mpm::Result bar = mpm::simulate(scene);
  double top = 0;
  double bottom = 0;
  for (const mpm::HistoryRow& row : bar.history) {
    top += row.stress_top;
    bottom = std::max(bottom, std::abs(row.stress_bottom));
  }
  top /= static_cast<double>(bar.history.size() - 1);
  const double exact = std::sqrt(20e9 * 2400) * velocity;
  mpm::Scene breaking = concrete(40, 40);
  breaking.loading.velocity = velocity;
  breaking.loading.stop_strain = 0.05;
  const mpm::Result broken = mpm::simulate(breaking);
  return Judge()
      .near("mean stress at the head", top, exact, 2e-2)
      .below("at the foot over it", bottom / exact, 1e-2)
      .must(broken.tension_failures > 50 && is_finite(broken),
            fmt::format("of concrete {} points fail", broken.tension_failures))
      .below("ledger off by", std::max(bar.energy_error, broken.energy_error), 1e-9)
      .finding();
}

/// Each transit adds rho c v to the stress on one side, twice, and then on the other: a staircase.
Finding stepwise() {
  const mpm::Result bar = mpm::simulate(struck_bar(0.05, 10));
  const double c = std::sqrt(20e9 / 2400);
  const double step = 2400 * c * 0.05;
  double off = 0;
  double most = 0;
  for (const mpm::HistoryRow& row : bar.history) {
    const double transits = row.time * c / 0.08;
    off += row.stress_top / step - (1 + 2 * std::floor(transits / 2));
    most = std::max(most, std::abs(row.stress_top / step - (1 + 2 * std::floor(transits / 2))));
  }
  off /= static_cast<double>(bar.history.size());
  return Judge()
      .below("mean distance from the staircase, in steps,", std::abs(off), 2e-2)
      .note(fmt::format("largest {:.2f}, at its edges", most))
      .below("ledger off by", bar.energy_error, 1e-9)
      .finding();
}

}  // namespace

std::vector<StabilityCase> loading_cases() {
  return {
      {"slow", "1e-4 m/s: as good as static, whole and breaking", slow},
      {"fast", "100 m/s: rho c v behind the front of the wave, nothing ahead; concrete breaks", fast},
      {"stepwise", "full speed at once: the staircase of a struck bar", stepwise},
  };
}

}  // namespace app::bench
