// Pieces that hang on no platen any more.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace quasi_static_loose_test {

using mpm::Result;
using mpm::Scene;

/// Pulled; the weak phase breaks at 3 MPa, or at less.
Scene block(int rows, int cols) {
  Scene scene = samples::unbreakable(samples::mortar_block(rows, cols));
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.stop_strain = 1e-2;
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  mpm::Phase weak = *scene.phases[samples::mortar];
  weak.weibull_modulus = 1e9;
  weak.tensile_scale = 3e6;
  scene.phases[samples::aggregate] = weak;
  return scene;
}

TEST(QuasiStaticLoose, NothingIsLeftOnceTheLastConnectionIsBroken) {
  for (const bool pixel : {true, false}) {
    Scene scene = block(12, 8);
    scene.pixel_cells = pixel;
    scene.points_per_cell = pixel ? 1 : 2;
    scene.labels.middleRows(4, 2).setConstant(samples::aggregate);
    mpm::Frame last;
    scene.frames = 1;
    mpm::RunHooks hooks;
    hooks.frames = [&](const mpm::Frame& frame) { last = frame; };
    const Result result = mpm::simulate(scene, hooks);
    EXPECT_NEAR(result.peak_stress, 3e6, 10);
    EXPECT_EQ(result.history.back().stress, 0);
    EXPECT_EQ(result.history.back().elastic, 0);
    EXPECT_EQ(result.history.back().strain, 1e-2);
    for (const mpm::FramePoint& point : last.points) EXPECT_EQ(point.syy, 0);
    // The upper part has moved with its platen, the lower one has stayed.
    EXPECT_NEAR(last.points.front().uy, 1e-2 * scene.height(), 1e-12);
    EXPECT_NEAR(last.points.back().uy, 0, 1e-12);
  }
}

TEST(QuasiStaticLoose, ANarrowBridgeBreaksAwayFromAnIsland) {
  // Two weak rows with a strong block between them, whose way to both platens is cut.
  Scene scene = block(20, 8);
  scene.labels.row(6).setConstant(samples::aggregate);
  scene.labels.row(13).setConstant(samples::aggregate);
  scene.phases[samples::itz] = *scene.phases[samples::aggregate];
  scene.phases[samples::itz]->tensile_scale = 3.0001e6;
  scene.labels.row(13).setConstant(samples::itz);
  scene.event_tolerance = 0.01;  // so that both rows break at once
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.tension_failures, 16);
  EXPECT_EQ(result.history.back().stress, 0);
}

/// A block with an island of the same phase in a hole.
Scene with_island(int size) {
  Scene scene = block(48, 48);
  scene.labels.block(10, 10, 28, 28).setZero();
  if (size > 0) scene.labels.block(14, 14, size, size).setConstant(samples::mortar);
  return scene;
}

TEST(QuasiStaticLoose, AnIslandChangesNothing) {
  const Result without = mpm::simulate(with_island(0));
  const Result with = mpm::simulate(with_island(20));
  EXPECT_EQ(with.history.back().stress, without.history.back().stress);
}

TEST(QuasiStaticLoose, IslandsAreNoBurdenToTheIteration) {
  const auto iterations = [](const Scene& scene) {
    const mpm::Plan plan = mpm::plan(scene);
    mpm::QuasiStaticSolver solver(scene, plan);
    (void)solver.advance(1);
    return solver.iterations();
  };
  EXPECT_EQ(iterations(with_island(20)), iterations(with_island(0)));
}

// The frame around breaks everywhere: what is left are pieces of all kinds, and every run comes to its end.
TEST(QuasiStaticLoose, EndsWhateverBreaks) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Scene scene = samples::small_concrete(40, 40);
    scene.method = mpm::SolverMethod::quasi_static;
    scene.pixel_cells = true;
    scene.points_per_cell = 1;
    scene.damage.seed = seed;
    scene.loading.stop_strain = 0.02;
    const Result result = mpm::simulate(scene);
    // A chain of hinges may still join the platens, through failed points only.
    EXPECT_LT(std::abs(result.history.back().stress), 0.01 * result.peak_stress) << seed;
    EXPECT_EQ(result.history.back().strain, 0.02);
    EXPECT_LT(result.energy_error, 1e-12);
  }
}

TEST(QuasiStaticLoose, EverythingMayFail) {
  Scene scene = block(8, 8);
  scene.labels.setConstant(samples::aggregate);
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.tension_failures, 64);
  EXPECT_EQ(result.history.back().stress, 0);
  EXPECT_TRUE(result.nothing_carries);
}

TEST(QuasiStaticLoose, IsTakenUpFromACheckpoint) {
  Scene scene = with_island(20);
  scene.labels.row(5).setConstant(samples::aggregate);
  scene.labels.row(44).setConstant(samples::itz);
  scene.phases[samples::itz] = *scene.phases[samples::aggregate];
  scene.phases[samples::itz]->weibull_modulus = 5;
  scene.phases[samples::aggregate]->weibull_modulus = 5;
  scene.event_tolerance = 0;
  const Result whole = mpm::simulate(scene);
  const samples::Interrupted run = samples::stopped_after(scene, 8);
  EXPECT_EQ(run.half.stop, mpm::StopReason::interrupted);
  const Result resumed = mpm::resume(scene, run.kept);
  ASSERT_EQ(resumed.history.size(), whole.history.size());
  for (std::size_t i = 0; i < whole.history.size(); ++i)
    EXPECT_EQ(resumed.history[i].stress, whole.history[i].stress) << i;
}

}  // namespace quasi_static_loose_test
