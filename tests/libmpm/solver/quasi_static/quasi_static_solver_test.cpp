#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/softening.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace quasi_static_solver_test {

using mpm::Result;
using mpm::Scene;

Scene concrete(int rows = 40, int cols = 40) {
  Scene scene = samples::small_concrete(rows, cols);
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.stop_strain = 1e-3;
  return scene;
}

TEST(QuasiStatic, AWeakRowCarriesItsStrengthAndThenNothing) {
  for (const mpm::Direction direction : {mpm::Direction::tension, mpm::Direction::compression}) {
    Scene scene = samples::unbreakable(samples::mortar_block(12, 8));
    scene.method = mpm::SolverMethod::quasi_static;
    scene.pixel_cells = true;
    scene.points_per_cell = 1;
    scene.loading.direction = direction;
    scene.loading.stop_strain = 1e-2;
    for (auto& phase : scene.phases)
      if (phase) phase->poisson = 0;
    mpm::Phase weak = *scene.phases[2];
    weak.weibull_modulus = 1e9;
    const bool pulled = direction == mpm::Direction::tension;
    if (pulled) {
      weak.tensile_scale = 3e6;
    } else {  // -s3 (1 - sin) > 2 c cos: uniaxial strength 2 c cos / (1 - sin)
      weak.cohesion = 3e6 * (1 - std::sin(0.6)) / (2 * std::cos(0.6));
      weak.friction_angle = 0.6;
    }
    scene.phases[samples::aggregate] = weak;
    scene.labels.row(5).setConstant(samples::aggregate);
    const Result result = mpm::simulate(scene);
    EXPECT_NEAR(result.peak_stress, 3e6, 10);
    EXPECT_EQ(pulled ? result.tension_failures : result.shear_failures, 8);
    EXPECT_LT(std::abs(result.history.back().stress), 3e4);
    EXPECT_NEAR(result.history.back().strain, 1e-2, 1e-12);
  }
}

TEST(QuasiStatic, TheLedgerCloses) {
  const Result result = mpm::simulate(concrete());
  EXPECT_GT(result.tension_failures, 50);
  EXPECT_LT(result.energy_error, 1e-12);
  const mpm::HistoryRow& last = result.history.back();
  EXPECT_GT(last.released, 0);
  EXPECT_NEAR(last.platen_work, last.elastic + last.released, 1e-9 * last.platen_work);
  // The work is the area under the curve.
  const Scene scene = concrete();
  EXPECT_GT(samples::area_under(result, scene), 0.9 * last.platen_work);
  EXPECT_LT(samples::area_under(result, scene), 1.1 * last.platen_work);  // drops are drawn as slopes
}

TEST(QuasiStatic, StrainsNeverFallAndFailuresHappenAtThem) {
  const Result result = mpm::simulate(concrete());
  for (std::size_t i = 1; i < result.history.size(); ++i)
    EXPECT_GE(result.history[i].strain, result.history[i - 1].strain);
  std::int64_t failed = 0;
  for (const float strain : result.failure_strain.reshaped()) failed += std::isfinite(strain) ? 1 : 0;
  EXPECT_EQ(failed, result.tension_failures + result.shear_failures);
}

TEST(QuasiStatic, EndsAtAStrainAtWhichAPointFails) {
  Scene scene = concrete(24, 24);
  const Result whole = mpm::simulate(scene);
  scene.loading.stop_strain = whole.history[10].strain;
  const Result part = mpm::simulate(scene);
  EXPECT_EQ(part.history.back().strain, scene.loading.stop_strain);
  EXPECT_NEAR(part.history[10].stress / whole.history[10].stress, 1, 1e-12);
}

TEST(QuasiStatic, SmallerTolerancesLeadToOneFailureAtATime) {
  Scene scene = concrete(24, 24);
  scene.damage.seed = 6;
  scene.event_tolerance = 0;
  const Result single = mpm::simulate(scene);
  scene.event_tolerance = 0.01;
  const Result grouped = mpm::simulate(scene);
  EXPECT_LT(grouped.steps, single.steps);
  EXPECT_NEAR(grouped.peak_stress, single.peak_stress, 0.01 * single.peak_stress);
}

TEST(QuasiStatic, EndsWhenTheStressHasDropped) {
  Scene scene = concrete();
  scene.loading.stop_drop = 0.5;
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.stop, mpm::StopReason::drop);
  EXPECT_LT(result.history.back().stress, 0.5 * result.peak_stress);
}

/// A bar of one weak row that softens, pulled until it is through.
Scene softening_bar(int rows, double fracture_energy) {
  Scene scene = samples::unbreakable(samples::mortar_block(rows, 8));
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.stop_strain = 0.5;
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  mpm::Phase weak = *scene.phases[2];
  weak.tensile_scale = 3e6;
  weak.weibull_modulus = 1e9;
  weak.fracture_energy = fracture_energy;
  scene.phases[samples::aggregate] = weak;
  scene.labels.row(rows / 2).setConstant(samples::aggregate);
  return scene;
}

TEST(QuasiStatic, ACrackBandDissipatesItsFractureEnergy) {
  for (const int rows : {4, 12})
    for (const double energy : {40.0, 100.0}) {
      const Scene scene = softening_bar(rows, energy);
      const Result result = mpm::simulate(scene);
      EXPECT_NEAR(result.peak_stress, 3e6, 100) << rows;
      EXPECT_EQ(result.tension_failures, 8);
      EXPECT_NEAR(result.history.back().released, energy * scene.width(), 0.01 * energy * scene.width())
          << rows << " rows, " << energy << " J/m2";
    }
}

TEST(QuasiStatic, ACrackBandOfAnyCurveDissipatesItsFractureEnergy) {
  for (const auto curve : {mpm::SofteningCurve::bilinear, mpm::SofteningCurve::hordijk}) {
    Scene scene = softening_bar(4, 60);
    scene.phases[samples::aggregate]->softening = curve;
    const Result result = mpm::simulate(scene);
    EXPECT_NEAR(result.peak_stress, 3e6, 100);
    EXPECT_NEAR(result.history.back().released, 60 * scene.width(), 0.01 * 60 * scene.width());
  }
}

TEST(QuasiStatic, ASofteningStripFollowsItsCurve) {
  for (const auto shape :
       {mpm::SofteningCurve::exponential, mpm::SofteningCurve::bilinear, mpm::SofteningCurve::hordijk}) {
    Scene scene = softening_bar(6, 60);
    scene.phases[samples::aggregate]->softening = shape;
    const Result result = mpm::simulate(scene);
    const mpm::Phase& weak = *scene.phases[samples::aggregate];
    const mpm::Softening curve = mpm::softening(weak, scene.plane, 3e6, scene.pixel_size);
    int compared = 0;
    for (const mpm::HistoryRow& row : result.history) {
      if (row.stress > 2.9e6 || row.stress < 0.3e6) continue;
      // Strain of the row that softens: what the others do not take.
      const double inside = row.strain * scene.height() - row.stress / weak.young * 5 * scene.pixel_size;
      EXPECT_NEAR(row.stress, curve.stress_at(inside / scene.pixel_size), 0.07 * row.stress);
      ++compared;
    }
    EXPECT_GT(compared, 10);
  }
}

TEST(QuasiStatic, GoesOnAsIfItHadNeverStopped) {
  for (const double energy : {0.0, 100.0}) {
    Scene scene = concrete(24, 24);
    samples::set_fracture_energy(scene, energy);
    const Result whole = mpm::simulate(scene);
    const samples::Interrupted run = samples::stopped_after(scene, 20);
    EXPECT_EQ(run.half.stop, mpm::StopReason::interrupted);
    const Result resumed = mpm::resume(scene, run.kept);
    ASSERT_EQ(resumed.history.size(), whole.history.size());
    for (std::size_t i = 0; i < whole.history.size(); ++i) {
      EXPECT_EQ(resumed.history[i].stress, whole.history[i].stress) << i;
      EXPECT_EQ(resumed.history[i].released, whole.history[i].released) << i;
    }
    EXPECT_TRUE((resumed.failure_mode == whole.failure_mode).all());
  }
}

TEST(QuasiStatic, FailsAlikeOnAnyNumberOfThreads) {
  Scene scene = concrete(130, 110);
  scene.event_tolerance = 0.02;
  const auto run = [&](int threads) {
    scene.threads = threads;
    mpm::RunHooks hooks;
    int rows = 0;
    hooks.observer = [&](const mpm::Progress&) { return ++rows < 20; };
    return mpm::simulate(scene, hooks);
  };
  const Result one = run(1);
  for (const int threads : {2, 3}) {
    const Result several = run(threads);
    EXPECT_EQ(several.threads, threads);
    ASSERT_EQ(several.history.size(), one.history.size());
    for (std::size_t i = 0; i < one.history.size(); ++i) {
      EXPECT_EQ(several.history[i].stress, one.history[i].stress) << i;
      EXPECT_EQ(several.history[i].strain, one.history[i].strain) << i;
    }
    EXPECT_TRUE((several.failure_mode == one.failure_mode).all());
  }
}

TEST(QuasiStatic, FramesShowTheStressThatIsCarried) {
  Scene scene = concrete(24, 24);
  scene.frames = 4;
  mpm::Frame last;
  mpm::RunHooks hooks;
  hooks.frames = [&](const mpm::Frame& frame) { last = frame; };
  const Result result = mpm::simulate(scene, hooks);
  double sum = 0;
  for (const mpm::FramePoint& point : last.points) sum += point.syy;
  EXPECT_NEAR(sum / static_cast<double>(last.points.size()), result.history.back().stress,
              0.02 * result.peak_stress);
}

// Slow explicit loading with damping comes to the same strength.
TEST(QuasiStatic, IsTheLimitOfSlowDampedLoading) {
  Scene scene = concrete(24, 24);
  scene.damage.seed = 2;
  scene.event_tolerance = 0;
  scene.loading.stop_strain = 2e-4;
  const Result still = mpm::simulate(scene);
  scene.method = mpm::SolverMethod::explicit_;
  scene.loading.velocity = 0.001;
  scene.local_damping = 0.3;
  const Result slow = mpm::simulate(scene);
  EXPECT_NEAR(slow.peak_stress, still.peak_stress, 0.005 * still.peak_stress);
}

TEST(QuasiStatic, RefusesWhatItDoesNotHave) {
  const auto message = [](auto&& change) {
    Scene scene = concrete(12, 12);
    change(scene);
    try {
      (void)mpm::simulate(scene);
    } catch (const mpm::Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(
      message([](Scene& s) { s.damage.crack_closure = mpm::CrackClosure::clipped; }),
      "damage.crack_closure: clipped; leaves it to the motion how far a crack opens, so that equilibrium "
      "has no single answer; choose damage.crack_closure = \"unilateral\", or solver.method = "
      "\"explicit\"");
  EXPECT_EQ(message([](Scene& s) { s.event_tolerance = 1; }),
            "solver.event_tolerance: 1; must lie in [0, 1)");
}

}  // namespace quasi_static_solver_test
