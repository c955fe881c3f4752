// What fails, down to the last point.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/solver/threshold.hpp"

namespace app::bench {
namespace {

/// A phase that cracks. scale [Pa].
mpm::Phase brittle(double scale, double weibull_modulus, double poisson = 0) {
  mpm::Phase phase = elastic(20e9, poisson);
  phase.name = "brittle";
  phase.tensile_scale = scale;
  phase.weibull_modulus = weibull_modulus;
  return phase;
}

/// One row of cells between the platens: all of it is strained alike, whatever fails.
mpm::Scene low_block(const mpm::Phase& phase) {
  mpm::Scene scene = block(2, 64, phase);
  scene.loading.stop_strain = 1e-3;
  return scene;
}

Finding residual_stiffness() {
  mpm::Scene scene = concrete(40, 40);
  const mpm::Result none = mpm::simulate(scene);
  scene.damage.residual_stiffness = 1e-12;
  const mpm::Result tiny = mpm::simulate(scene);
  return Judge()
      .must(none.tension_failures > 200, fmt::format("{} points fail", none.tension_failures))
      .below("ledger off by", std::max(none.energy_error, tiny.energy_error), 1e-9)
      .near("peak with 1e-12 [Pa]", tiny.peak_stress, none.peak_stress, 1e-6)
      .finding();
}

/// What is left of the stress is that of one pixel of 64 x 2, half of the height of its cell: the others have
/// their mass and no stiffness.
Finding single_live_point() {
  Judge judge;
  for (const double cfl : {0.5, 0.99}) {
    mpm::Scene scene = low_block(brittle(1e3, 1.5));
    scene.phases.emplace_back(elastic(20e9, 0.2));
    scene.labels(0, 31) = second;
    scene.cfl = cfl;
    load_slowly(scene, 1e-3, 3000);  // all the mass of the ghosts hangs on that one point
    const mpm::Result result = mpm::simulate(scene);
    judge.must(result.tension_failures == 127 && !result.nothing_carries,
               fmt::format("at CFL {}: {} of 128 points fail", cfl, result.tension_failures));
    judge.near("stress over strain [Pa]", end_modulus(result),
               plane_modulus(*scene.phases[second]) * 0.5 / 64, 1e-2);
  }
  return judge.finding();
}

Finding nothing_carries() {
  Judge judge;
  for (const auto kinematics :
       {mpm::Kinematics::small_strain, mpm::Kinematics::moving, mpm::Kinematics::automatic}) {
    mpm::Scene scene = low_block(brittle(1e5, 1.5));
    scene.kinematics = kinematics;
    scene.loading.ramp_time = 0;  // a platen that gains speed feels the mass of what has failed
    const mpm::Result result = mpm::simulate(scene);
    const mpm::HistoryRow& last = result.history.back();
    judge.must(result.nothing_carries && is_finite(result),
               fmt::format("{} of 128 points fail, the run ends at strain {:.2g} of {:.2g}",
                           result.tension_failures, last.strain, scene.loading.stop_strain));
    judge.below("stress left over peak", std::abs(last.stress) / result.peak_stress, 1e-6);
  }
  return judge.finding();
}

/// Without Poisson's effect each point carries E times strain until that exceeds its strength: how many are
/// left, and what they carry, is known from their draws.
Finding weibull_moduli() {
  Judge judge;
  for (const double modulus : {0.1, 1.0, 100.0}) {
    mpm::Scene scene = low_block(brittle(15e6, modulus));
    const mpm::Result result = mpm::simulate(scene);
    const mpm::HistoryRow& last = result.history.back();
    const double stress = 20e9 * last.strain;
    int failed = 0;
    for (int row = 0; row < 2; ++row)
      for (int col = 0; col < 64; ++col)
        failed +=
            mpm::strength_factor(mpm::pixel_random(scene.damage.seed, row, col), modulus) * 15e6 < stress;
    judge.must(result.tension_failures == failed,
               fmt::format("at m = {:g}: {} of 128 points fail, by their draws {}", modulus,
                           result.tension_failures, failed));
    judge.below("stress off by", std::abs(last.stress - stress * (128 - failed) / 128) / stress, 1e-9);
  }
  return judge.finding();
}

/// Strength of a point of this draw, on both sides of it, and as the sweeps keep it.
bool is_sharp(const mpm::Phase& phase, double random) {
  const double factor = mpm::strength_factor(random, phase.weibull_modulus);
  const double strength = mpm::tension_threshold(phase, factor);
  const mpm::DamageLaw law;
  const mpm::PointState point = mpm::intact_point(phase, factor);
  const auto fails = [&](double stress) {
    return mpm::respond(point, {0, stress, 0}, law).failure == mpm::FailureMode::tension;
  };
  const float kept = mpm::stored_threshold(strength, 1);
  return std::isfinite(factor) && factor > 0 && kept >= 0 &&
         (static_cast<double>(kept) <= strength || kept == mpm::kernels::unreachable) &&
         fails(strength * (1 + 1e-12)) && !fails(strength * (1 - 1e-12));
}

Finding extreme_draws() {
  const double smallest = 0x1p-53;
  const double largest = 1 - 0x1p-53;
  Judge judge;
  for (const double modulus : {0.1, 1.5, 100.0}) {
    const mpm::Phase phase = brittle(15e6, modulus);
    judge.must(is_sharp(phase, smallest) && is_sharp(phase, largest),
               fmt::format("at m = {:g}: strengths {:.3g} and {:.3g} Pa", modulus,
                           15e6 * mpm::strength_factor(largest, modulus),
                           15e6 * mpm::strength_factor(smallest, modulus)));
  }
  double least = 1;
  double most = 0;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) {
    const double r = mpm::uniform_random(1, i, 0);
    least = std::min(least, r);
    most = std::max(most, r);
  }
  // Of a million draws the extremes lie within 1e-7 ... 1e-5 of 0 and 1 but for one time in ten.
  return judge
      .must(least >= smallest && most <= largest && least < 1e-5 && most > 1 - 1e-5,
            fmt::format("of a million draws, {:.2g} to 1 - {:.2g}", least, 1 - most))
      .finding();
}

}  // namespace

std::vector<StabilityCase> strength_cases() {
  return {
      {"residual-stiffness", "0 and 1e-12 of the stiffness left: the same peak, energies that close",
       residual_stiffness},
      {"single-live-point", "one point between ghosts: it carries E / (1 - nu^2) times strain",
       single_live_point},
      {"nothing-carries", "a specimen that fails altogether: the run says so and ends there, at no stress",
       nothing_carries},
      {"weibull", "Weibull modulus 0.1 to 100: as many points fail as their draws say", weibull_moduli},
      {"extreme-draws", "the smallest and the largest draw: a strength above 0, and a point that fails there",
       extreme_draws},
  };
}

}  // namespace app::bench
