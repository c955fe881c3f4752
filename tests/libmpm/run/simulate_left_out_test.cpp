// Runs that differ only in what they leave out agree to rounding: a test for each feature of the plan.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/plan.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace simulate_left_out_test {

using mpm::kernels::Check;

struct LeftOut : testing::TestWithParam<mpm::Kinematics> {
  static mpm::Scene concrete() {
    mpm::Scene scene = samples::pulled(samples::small_concrete(40, 40));
    scene.kinematics = GetParam();
    return scene;
  }
  static mpm::Scene elastic() { return samples::unbreakable(concrete()); }

  /// The run by its own plan, and by one that has more.
  static void expect_same(const mpm::Scene& scene, const std::function<void(mpm::Plan&)>& add,
                          double tolerance) {
    const mpm::Result lean = mpm::simulate(scene);
    mpm::Plan plan = mpm::plan(scene);
    add(plan);
    const mpm::Result full = mpm::simulate(scene, plan);
    ASSERT_EQ(lean.steps, full.steps);
    EXPECT_NEAR(lean.peak_stress, full.peak_stress, tolerance * lean.peak_stress);
    EXPECT_NEAR(lean.history.back().stress, full.history.back().stress, tolerance * lean.peak_stress);
    EXPECT_NEAR(lean.history.back().kinetic, full.history.back().kinetic,
                tolerance * lean.history.back().elastic);
    EXPECT_EQ(lean.tension_failures, full.tension_failures);
    EXPECT_EQ(lean.shear_failures, full.shear_failures);
  }
};

TEST_P(LeftOut, BothTestsWhereNothingCanFail) {
  expect_same(
      elastic(),
      [](mpm::Plan& plan) {
        plan.features.check = plan.moving.features.check = Check::tension_and_shear;
        plan.moving.optional.tension = plan.moving.optional.crush = true;
      },
      1e-12);
}

TEST_P(LeftOut, TheShearTestWhereNothingShears) {
  mpm::Scene scene = concrete();
  for (auto& phase : scene.phases)
    if (phase) phase->cohesion = mpm::Phase::unbreakable;
  ASSERT_GT(mpm::simulate(scene).tension_failures, 100);
  expect_same(
      scene,
      [](mpm::Plan& plan) {
        plan.features.check = plan.moving.features.check = Check::tension_and_shear;
        plan.moving.optional.crush = true;
      },
      1e-12);
}

TEST_P(LeftOut, CrackClosureWhereNothingCracks) {
  expect_same(
      elastic(),
      [](mpm::Plan& plan) {
        plan.features.crack_closure = plan.moving.features.crack_closure = true;
        plan.features.check = plan.moving.features.check = Check::tension_and_shear;
        plan.moving.optional.tension = plan.moving.optional.crush = plan.moving.optional.cracked = true;
      },
      1e-11);
}

TEST_P(LeftOut, DampingOfNothing) {
  expect_same(
      concrete(), [](mpm::Plan& plan) { plan.features.damping = plan.moving.features.damping = true; },
      1e-12);
}

TEST_P(LeftOut, TheSecondElasticConstant) {
  if (GetParam() != mpm::Kinematics::small_strain) return;  // moving points always have both
  expect_same(
      elastic(), [](mpm::Plan& plan) { plan.features.one_poisson_ratio = false; }, 1e-9);
}

TEST_P(LeftOut, EnergiesAtEveryStep) {
  mpm::Scene scene = concrete();
  expect_same(
      scene, [](mpm::Plan& plan) { plan.steps_per_row = 1; }, 0.02);  // more rows see a higher peak
  mpm::Plan plan = mpm::plan(scene);
  plan.steps_per_row = 1;
  const mpm::Result often = mpm::simulate(scene, plan);
  const mpm::Result seldom = mpm::simulate(scene);
  EXPECT_EQ(often.history.back().stress, seldom.history.back().stress);
  EXPECT_EQ(often.history.back().elastic, seldom.history.back().elastic);
}

TEST_P(LeftOut, TheDeformationGradient) {
  if (GetParam() == mpm::Kinematics::small_strain) return;  // points that stay have none
  const mpm::Scene scene = concrete();
  expect_same(
      scene, [](mpm::Plan& plan) { plan.moving.optional.deformation = true; }, 1e-12);
  mpm::Plan plan = mpm::plan(scene);
  plan.moving.optional.deformation = true;
  const mpm::Result result = mpm::simulate(scene, plan);
  double stretch = 0;
  for (Eigen::Index i = 0; i < result.deformation[3].size(); ++i)
    stretch += static_cast<double>(result.deformation[3].data()[i]) - 1;
  EXPECT_NEAR(stretch / static_cast<double>(result.deformation[3].size()), result.history.back().strain,
              0.3 * result.history.back().strain);
  EXPECT_EQ(mpm::simulate(scene).deformation[3].size(), 0);
}

TEST_P(LeftOut, TheBlendWithPic) {
  if (GetParam() == mpm::Kinematics::small_strain) return;
  expect_same(
      concrete(), [](mpm::Plan& plan) { plan.moving.features.transfer = mpm::moving::Return::blend; }, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinematics, LeftOut,
                         testing::Values(mpm::Kinematics::small_strain, mpm::Kinematics::moving),
                         [](const auto& one) {
                           return one.param == mpm::Kinematics::moving ? "Moving" : "SmallStrain";
                         });

}  // namespace simulate_left_out_test
