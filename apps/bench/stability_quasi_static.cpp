// Equilibrium without inertia: stiffness, pictures and failures at their extremes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/bench/stability_scenes.hpp"

namespace app::bench {
namespace {

mpm::Scene still(mpm::Scene scene, double stop_strain = 1e-3) {
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.stop_strain = stop_strain;
  return scene;
}

double still_modulus(const mpm::Result& result) {
  return result.history.back().stress / result.history.back().strain;
}

/// Rigid is rigid: a thousand times more changes nothing.
Finding rigid_aggregate() {
  mpm::Scene scene = still(unbreakable(concrete(60, 60)));
  const double soft = scene.phases[second]->young;
  scene.phases[first]->young = 1e6 * soft;
  const double million = still_modulus(mpm::simulate(scene));
  scene.phases[first]->young = 1e9 * soft;
  return Judge().near("modulus", still_modulus(mpm::simulate(scene)), million, 1e-4).finding();
}

Finding still_incompressible() {
  Judge judge;
  for (const double poisson : {0.49, 0.4999}) {
    const mpm::Scene scene = still(block(48, 36, elastic(20e9, poisson)));
    judge.near(fmt::format("modulus at nu {}", poisson), still_modulus(mpm::simulate(scene)),
               20e9 / (1 - poisson * poisson), 1e-5);
  }
  return judge.finding();
}

/// One column of pixels with one weak pixel.
Finding still_single_column() {
  mpm::Scene scene = still(block(40, 1, elastic(20e9, 0)));
  mpm::Phase weak = elastic(20e9, 0);
  weak.tensile_scale = 2e6;
  weak.weibull_modulus = 1e9;
  scene.phases.resize(third, std::nullopt);
  scene.phases[second] = weak;
  scene.labels(17, 0) = second;
  const mpm::Result result = mpm::simulate(scene);
  return Judge()
      .near("peak", result.peak_stress, 2e6, 1e-6)
      .below("stress in the end over the peak", std::abs(result.history.back().stress) / 2e6, 1e-3)
      .must(result.tension_failures == 1, fmt::format("{} failure", result.tension_failures))
      .finding();
}

/// Every point has the same strength: all of them fail at once, and nothing carries.
Finding still_all_at_once() {
  mpm::Phase same = elastic();
  same.tensile_scale = 3e6;
  same.weibull_modulus = 1e9;
  const mpm::Result result = mpm::simulate(still(block(24, 24, same)));
  return Judge()
      .near("peak", result.peak_stress, 3e6, 1e-6)
      .must(result.nothing_carries,
            fmt::format("{} of {} points failed", result.tension_failures, result.points))
      .finding();
}

/// Pulled far beyond its crack, with fragments that hang on nothing.
Finding still_fragments() {
  const mpm::Result result = mpm::simulate(still(concrete(60, 60), 0.02));
  const double rest = std::abs(result.history.back().stress) / result.peak_stress;
  return Judge()
      .must(result.stop == mpm::StopReason::strain, fmt::format("{} failures", result.tension_failures))
      .below("stress in the end over the peak", rest, 0.02)
      .below("ledger off by", result.energy_error, 1e-9)
      .finding();
}

/// Pixels that hold together by their corners alone.
Finding still_checkerboard() {
  mpm::Scene scene = still(block(24, 24, elastic()));
  for (int row = 0; row < 24; ++row)
    for (int col = 0; col < 24; ++col)
      if ((row + col) % 2 == 1) scene.labels(row, col) = 0;
  const mpm::Result result = mpm::simulate(scene);
  const double share = still_modulus(result) / 20e9;
  return Judge()
      .must(share > 0.01 && share < 0.5, fmt::format("modulus {:.3g} of that of the full block", share))
      .finding();
}

/// A cavity with a loose grain in it, and a slit from the side.
Finding still_loose_parts() {
  mpm::Scene scene = still(concrete(60, 60));
  scene.labels.block(20, 20, 20, 20).setZero();
  scene.labels.block(27, 27, 6, 6).setConstant(first);
  scene.labels.block(45, 0, 1, 30).setZero();
  const mpm::Result result = mpm::simulate(scene);
  return Judge()
      .must(result.peak_stress > 0 && std::isfinite(result.peak_stress),
            fmt::format("peak {:.3g} MPa", 1e-6 * result.peak_stress))
      .below("ledger off by", result.energy_error, 1e-9)
      .finding();
}

}  // namespace

std::vector<StabilityCase> quasi_static_cases() {
  return {
      {"still-contrast", "aggregate 1e9 times as stiff as mortar: the modulus of 1e6 times", rigid_aggregate},
      {"still-incompressible", "nu 0.49 and 0.4999: E / (1 - nu^2)", still_incompressible},
      {"still-column", "a single column with a weak pixel: its strength, then nothing", still_single_column},
      {"still-all-at-once", "all points equally strong: their strength, then nothing carries",
       still_all_at_once},
      {"still-fragments", "far beyond the crack: equilibrium, no stress, a ledger that closes",
       still_fragments},
      {"still-checkerboard", "pixels that touch at corners only: a finite modulus", still_checkerboard},
      {"still-loose-parts", "a grain that hangs on nothing: a peak, a ledger that closes", still_loose_parts},
  };
}

}  // namespace app::bench
