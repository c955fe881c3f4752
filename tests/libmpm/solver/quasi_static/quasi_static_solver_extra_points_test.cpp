// Several points in a pixel, each of which fails alone, in equilibrium.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/quasi_static/equilibrium.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace quasi_static_solver_extra_points_test {

using mpm::Result;
using mpm::Scene;

Scene with_cells(Scene scene, bool pixel) {
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = pixel;
  scene.points_per_cell = pixel ? 1 : 2;
  return scene;
}

/// A block with extra points of a phase: one in each pixel of a row, off its middle, and two in the first.
Scene with_points(Scene scene, bool pixel, std::uint8_t phase) {
  const double d = scene.pixel_size;
  for (int col = 0; col < scene.labels.cols(); ++col)
    scene.extra_points.push_back({(col + 0.3) * d, 5.6 * d, phase});
  scene.extra_points.push_back({0.8 * d, 5.1 * d, phase});
  return with_cells(scene, pixel);
}

double modulus(const Scene& scene) {
  mpm::Equilibrium equilibrium(scene, mpm::plan(scene), mpm::StrengthFactors(scene, false));
  EXPECT_TRUE(equilibrium.solve(0));
  return equilibrium.modulus();
}

// All points of a pixel share its volume; away from its middle they do not integrate it exactly.
TEST(QuasiStaticExtraPoints, OfTheSamePhaseChangeNothing) {
  for (const bool pixel : {true, false})
    for (const double poisson : {0.2, 0.3}) {
      Scene scene = samples::unbreakable(samples::mortar_block(12, 8));
      scene.phases[samples::mortar]->poisson = poisson;
      const double young = scene.phases[samples::mortar]->young / (1 - poisson * poisson);
      EXPECT_NEAR(modulus(with_points(scene, pixel, samples::mortar)), young, 1e-3 * young);
      for (int col = 0; col < 8; ++col)
        scene.extra_points.push_back(
            {(col + 0.5) * scene.pixel_size, 5.5 * scene.pixel_size, samples::mortar});
      scene.extra_points.push_back(scene.extra_points.front());
      EXPECT_NEAR(modulus(with_cells(scene, pixel)), young, 1e-6 * young);
    }
}

// Half of each pixel of a row is twice as stiff, and two thirds of the first one: without Poisson's effect
// and with one column the row has the mean of both.
TEST(QuasiStaticExtraPoints, GiveTheirShare) {
  Scene scene = samples::unbreakable(samples::mortar_block(12, 1));
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  const double young = scene.phases[samples::mortar]->young;
  scene.phases[samples::itz]->young = 2 * young;
  const double d = scene.pixel_size;
  scene.extra_points = {{0.5 * d, 5.5 * d, samples::itz}};
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  EXPECT_NEAR(modulus(scene), young / (11.0 / 12 + 1 / (12 * 1.5)), 1e-6 * young);
}

// The point that is left carries on with its share alone.
TEST(QuasiStaticExtraPoints, FailAlone) {
  Scene scene = samples::unbreakable(samples::mortar_block(12, 8));
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  scene.phases[samples::itz]->young = scene.phases[samples::mortar]->young;
  scene.phases[samples::itz]->tensile_scale = 3e6;
  scene.phases[samples::itz]->weibull_modulus = 1e9;
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  const double d = scene.pixel_size;
  for (int col = 0; col < 8; ++col) scene.extra_points.push_back({(col + 0.5) * d, 5.5 * d, samples::itz});
  scene.loading.stop_strain = 2e-4;
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.tension_failures, 8);
  EXPECT_EQ(result.failure_mode.cast<int>().sum(), 0);
  for (const float strain : result.extra_failure_strain) EXPECT_NEAR(strain, 1.5e-4, 1e-9);
  const double young = scene.phases[samples::mortar]->young;
  EXPECT_NEAR(result.history.back().stress, 2e-4 * young / (11.0 / 12 + 2.0 / 12), 2e-5 * young * 2e-4);
  const double energy = 0.5 * 0.5 * 3e6 * 1.5e-4 * 8 * d * d;  // of the points when they fail
  EXPECT_GT(result.history.back().released, energy);           // and of what unloads around them
  EXPECT_LT(result.history.back().released, 2 * energy);
}

Scene concrete(bool pixel) {
  Scene scene = with_points(samples::small_concrete(24, 24), pixel, samples::itz);
  const double d = scene.pixel_size;
  for (int i = 0; i < 60; ++i)
    scene.extra_points.push_back(
        {12 * d * (1 + 0.9 * std::sin(1.0 + i)), 12 * d * (1 + 0.9 * std::cos(3.0 * i)), samples::itz});
  scene.loading.stop_strain = 4e-4;
  return scene;
}

TEST(QuasiStaticExtraPoints, TheLedgerClosesOnBothPaths) {
  for (const bool pixel : {true, false})
    for (const auto path : {mpm::LoadingPath::strain, mpm::LoadingPath::snap_back}) {
      Scene scene = concrete(pixel);
      scene.loading.path = path;
      const Result result = mpm::simulate(scene);
      EXPECT_LT(result.energy_error, 1e-12);
      std::int64_t failed = 0;
      for (const std::uint8_t mode : result.failure_mode.reshaped()) failed += mode != 0 ? 1 : 0;
      std::int64_t extra = 0;
      for (const std::uint8_t mode : result.extra_failure_mode) extra += mode != 0 ? 1 : 0;
      EXPECT_GT(extra, 10);
      EXPECT_EQ(failed + extra, result.tension_failures + result.shear_failures);
    }
}

TEST(QuasiStaticExtraPoints, FramesShowThem) {
  Scene scene = concrete(true);
  scene.frames = 1;
  scene.loading.stop_strain = 3e-5;
  mpm::Frame last;
  mpm::RunHooks hooks;
  hooks.frames = [&](const mpm::Frame& frame) { last = frame; };
  (void)mpm::simulate(scene, hooks);
  ASSERT_EQ(last.points.size(), 24 * 24 + scene.extra_points.size());
  const mpm::FramePoint& first = last.points[24 * 24];
  EXPECT_EQ(first.id, 24U * 24);
  EXPECT_NEAR(first.x - first.ux, scene.extra_points[0].x, 1e-15);
  EXPECT_GT(first.syy, 0);
  EXPECT_NEAR(first.uy, 3e-5 * scene.extra_points[0].y, 1e-5 * scene.height());
}

TEST(QuasiStaticExtraPoints, IsTheLimitOfSlowDampedLoading) {
  for (const auto closure : {mpm::CrackClosure::off, mpm::CrackClosure::unilateral}) {
    Scene scene = concrete(true);
    scene.damage.crack_closure = closure;
    scene.event_tolerance = 0;
    scene.loading.stop_strain = 2e-4;
    const Result still = mpm::simulate(scene);
    scene.method = mpm::SolverMethod::explicit_;
    scene.loading.velocity = 0.002;
    scene.local_damping = 0.3;
    const Result slow = mpm::simulate(scene);
    EXPECT_NEAR(slow.peak_stress, still.peak_stress, 0.01 * still.peak_stress);
  }
}

TEST(QuasiStaticExtraPoints, GoOnAsIfTheyHadNeverStopped) {
  for (const auto closure : {mpm::CrackClosure::off, mpm::CrackClosure::unilateral}) {
    Scene scene = concrete(true);
    scene.damage.crack_closure = closure;
    const Result whole = mpm::simulate(scene);
    const samples::Interrupted run =
        samples::stopped_after(scene, static_cast<int>(whole.history.size() / 2));
    const Result resumed = mpm::resume(scene, run.kept);
    ASSERT_EQ(resumed.history.size(), whole.history.size());
    for (std::size_t i = 0; i < whole.history.size(); ++i)
      EXPECT_EQ(resumed.history[i].stress, whole.history[i].stress) << i;
    EXPECT_EQ(resumed.tension_failures, whole.tension_failures);
    EXPECT_EQ(resumed.extra_failure_mode, whole.extra_failure_mode);
  }
}

}  // namespace quasi_static_solver_extra_points_test
