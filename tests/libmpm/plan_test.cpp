#include "libmpm/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace {

using mpm::kernels::Check;

TEST(Plan, TimeStepAndStepsOfThePapersTensionTest) {
  mpm::Scene scene = samples::mortar_block(300, 300);
  scene.labels(0, 0) = samples::aggregate;
  scene.loading.ramp_time = 0;
  const mpm::Plan plan = mpm::plan(scene);
  EXPECT_NEAR(plan.dt, 0.5 * 1e-3 / std::sqrt(40e9 * 0.8 / (1.2 * 0.6) / 2400), 1e-20);
  EXPECT_EQ(plan.steps, 10328);  // 4e-4 x 0.15 m / 0.05 m/s / dt = 10,327.9
  EXPECT_EQ(plan.steps_per_row, 10);
}

TEST(Plan, OnlyPhasesThatArePresentCount) {
  const mpm::Scene mortar_only = samples::mortar_block(4, 4);
  mpm::Scene with_aggregate = mortar_only;
  with_aggregate.labels(1, 1) = samples::aggregate;
  EXPECT_LT(mpm::plan(with_aggregate).dt, mpm::plan(mortar_only).dt);
}

TEST(Plan, LeavesOutWhatTheSceneDoesNotNeed) {
  mpm::Scene scene = samples::small_concrete();
  EXPECT_EQ(mpm::plan(scene).features.check, Check::tension_and_shear);
  EXPECT_TRUE(mpm::plan(scene).features.one_poisson_ratio);
  EXPECT_FALSE(mpm::plan(scene).features.damping);
  for (auto& phase : scene.phases)
    if (phase) phase->cohesion = mpm::Phase::unbreakable;
  EXPECT_EQ(mpm::plan(scene).features.check, Check::tension);
  scene.phases[samples::itz]->poisson = 0.25;
  EXPECT_FALSE(mpm::plan(scene).features.one_poisson_ratio);
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  EXPECT_TRUE(mpm::plan(scene).features.crack_closure);
  scene = samples::unbreakable(scene);
  EXPECT_EQ(mpm::plan(scene).features.check, Check::none);
  EXPECT_FALSE(mpm::plan(scene).features.crack_closure) << "what cannot crack has no crack to close";
}

TEST(Plan, ExtraPointsCountAmongThePhases) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  const double dt = mpm::plan(scene).dt;
  scene.extra_points = {{1e-3, 1e-3, samples::aggregate}};
  EXPECT_NEAR(mpm::plan(scene).dt, dt / std::sqrt(2.0), 1e-12 * dt);
}

TEST(Plan, RampsOverTwoTransitsOfTheSlowestWaveUnlessTold) {
  mpm::Scene scene = samples::mortar_block(40, 40);
  scene.labels(0, 0) = samples::aggregate;
  scene.labels(0, 1) = samples::itz;
  const double slowest = mpm::wave_speed(*scene.phases[samples::itz], scene.plane);
  EXPECT_NEAR(mpm::plan(scene).ramp_time, 2 * 20e-3 / slowest, 1e-15);
  scene.labels(0, 2) = samples::itz;
  scene.labels(0, 1) = samples::aggregate;
  scene.phases[samples::itz]->young = 60e9;
  EXPECT_NEAR(mpm::plan(scene).ramp_time,
              2 * 20e-3 / mpm::wave_speed(*scene.phases[samples::mortar], scene.plane), 1e-15);
  EXPECT_NEAR(mpm::plan(scene).wave_speed, mpm::wave_speed(*scene.phases[samples::itz], scene.plane), 1e-9);
  scene.loading.ramp_time = 3e-5;
  EXPECT_EQ(mpm::plan(scene).ramp_time, 3e-5);
}

TEST(Plan, AnEndlessRunIsRefused) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.loading.velocity = 1e-14;
  EXPECT_THROW((void)mpm::plan(scene), mpm::Error);
}

TEST(Ramp, IsSmoothAndCoversHalfTheWay) {
  mpm::Plan plan;
  plan.ramp_time = 2;
  EXPECT_EQ(mpm::ramp(plan, 0), 0);
  EXPECT_DOUBLE_EQ(mpm::ramp(plan, 1), 0.5);
  EXPECT_EQ(mpm::ramp(plan, 2), 1);
  EXPECT_NEAR(mpm::ramp(plan, 1e-4), 0, 1e-7);
  plan.ramp_time = 0;
  EXPECT_EQ(mpm::ramp(plan, 0), 1);
}

}  // namespace
