// How a run ends: where it was told to, when the observer asks, or because it diverged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/plan.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace simulate_stop_test {

using mpm::Result;
using mpm::Scene;

TEST(Stop, AtADropBelowThePeak) {
  Scene scene = samples::pulled(samples::small_concrete());
  scene.loading.stop_strain = 3e-3;
  scene.loading.stop_drop = 0.5;
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.stop, mpm::StopReason::drop);
  EXPECT_LT(result.history.back().stress, 0.5 * result.peak_stress);
  EXPECT_LT(result.history.back().strain, 1e-3);
}

TEST(Stop, NotAtADropWhileThePlatenStillGainsSpeed) {
  Scene scene = samples::pulled(samples::small_concrete());
  scene.loading.stop_drop = 0.5;
  scene.loading.ramp_time = 2.04 * scene.loading.stop_strain * scene.height() / scene.loading.velocity;
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.stop, mpm::StopReason::strain);
  EXPECT_LT(result.history.back().stress, 0.5 * result.peak_stress);
}

TEST(Stop, WhenTheObserverAsks) {
  int rows = 0;
  const Result result = mpm::simulate(samples::pulled(samples::small_concrete(20, 20)),
                                      {.observer = [&](const mpm::Progress& progress) {
                                        EXPECT_NEAR(progress.fraction, progress.row.strain / 3e-4, 1e-12);
                                        return ++rows < 7;
                                      }});
  EXPECT_EQ(result.stop, mpm::StopReason::interrupted);
  EXPECT_EQ(result.history.size(), 8U);
}

// What an observer copies in the middle is what a run that ends there leaves behind.
TEST(Stop, LeavesWhatWasSoFar) {
  Scene scene = samples::pulled(samples::small_concrete(40, 40));
  for (const mpm::Kinematics kinematics : {mpm::Kinematics::small_strain, mpm::Kinematics::moving}) {
    scene.kinematics = kinematics;
    const std::size_t rows = kinematics == mpm::Kinematics::moving ? 90 : 150;
    Result copy;
    mpm::RunHooks hooks;
    hooks.observer = [&](const mpm::Progress& progress) {
      copy = progress.so_far();
      return copy.history.size() < rows;
    };
    const Result result = mpm::simulate(scene, hooks);
    ASSERT_EQ(copy.history.size(), rows);
    EXPECT_EQ(result.history.back().stress, copy.history.back().stress);
    EXPECT_EQ(result.steps, copy.steps);
    EXPECT_EQ(result.energy_error, copy.energy_error);
    EXPECT_GT((copy.failure_mode.cast<int>() != 0).count(), 0) << "nothing failed, nothing is compared";
    EXPECT_TRUE((result.failure_mode == copy.failure_mode).all());
    ASSERT_EQ(result.end_x.size(), copy.end_x.size());
    EXPECT_TRUE((result.end_x == copy.end_x).all());
  }
}

TEST(Stop, AtTheStrainAskedFor) {
  Scene scene = samples::pulled(samples::small_concrete(20, 20));
  scene.history_rows = 170;  // no whole number of them makes the steps
  const Result result = mpm::simulate(scene);
  ASSERT_NE(mpm::plan(scene).steps % mpm::plan(scene).steps_per_row, 0);
  EXPECT_EQ(result.steps, mpm::plan(scene).steps + 1);
  EXPECT_EQ(result.stop, mpm::StopReason::strain);
  EXPECT_NEAR(result.history.back().strain, 3e-4, 3e-7);
}

TEST(Diverged, SaysWhereAndKeepsWhatWasComputed) {
  // One point of a cell alone, far stiffer for its mass than a full cell: the step from the wave speed is too
  // long.
  Scene scene = samples::unbreakable(samples::mortar_block(40, 40));
  scene.labels.setConstant(0);
  for (int i = 0; i < 40; ++i) scene.labels(i, i) = samples::mortar;
  scene.cfl = 1;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 0.5;
  try {
    (void)mpm::simulate(scene);
    FAIL() << "a diverging run must not end as if it were good";
  } catch (const mpm::Diverged& diverged) {
    EXPECT_THAT(diverged.what(), testing::HasSubstr("energy grows without work at step "));
    EXPECT_THAT(diverged.what(), testing::HasSubstr("try a smaller solver.cfl"));
    EXPECT_FALSE(diverged.result.history.empty());
    EXPECT_GT(diverged.result.steps, 0);
  }
}

// Damping holds back what gains speed and drives what loses it: at a step near the limit nodes turn round at
// every step, ever faster. Their kinetic energy, a product of two successive velocities, is then negative.
TEST(Diverged, IsNoticedWhenPositiveAndNegativeEnergiesGrowTogether) {
  Scene scene = samples::pulled(samples::small_concrete(20, 20));
  scene.pixel_size = 1e-3;
  scene.cfl = 1;
  scene.local_damping = 0.99;
  for (const int rows : {1000, 10}) {
    scene.history_rows = rows;
    mpm::Plan plan = mpm::plan(scene);
    plan.dt /= mpm::damped_share(scene.local_damping);
    try {
      const Result result = mpm::simulate(scene, plan);
      ADD_FAILURE() << "ended with a peak of " << result.peak_stress << " Pa";
    } catch (const mpm::Diverged& diverged) {
      EXPECT_THAT(diverged.what(), testing::HasSubstr("energy grows without work at step "));
      EXPECT_LT(diverged.result.peak_stress, 10e6) << "what is kept is from before";
    }
  }
}

}  // namespace simulate_stop_test
