#include "libmpm/solver/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace plan_test {

using mpm::kernels::Check;

TEST(Plan, TimeStepAndStepsOfThePapersTensionTest) {
  mpm::Scene scene = samples::mortar_block(300, 300);
  scene.labels(0, 0) = samples::aggregate;
  scene.loading.ramp_time = 0;
  const mpm::Plan plan = mpm::plan(scene);
  EXPECT_NEAR(plan.dt, 0.5 * 1e-3 / std::sqrt(40e9 * 0.8 / (1.2 * 0.6) / 2400), 1e-20);
  scene.local_damping = 0.44;  // as if it were stiffer by that
  EXPECT_NEAR(mpm::plan(scene).dt, plan.dt / 1.2, 1e-20);
  EXPECT_EQ(plan.steps, 10328);  // 4e-4 x 0.15 m / 0.05 m/s / dt = 10,327.9
  EXPECT_EQ(plan.steps_per_row, 10);
}

TEST(Plan, RefusesAGridThatNoMemoryHolds) {
  const auto message = [](double margin) -> std::string {
    mpm::Scene scene = samples::mortar_block(10, 10);  // pixels of 0.5 mm, cells of 1 mm
    scene.kinematics = mpm::Kinematics::moving;
    scene.motion.margin = margin;
    try {
      (void)mpm::plan(scene);
    } catch (const mpm::Error& error) {
      return error.what();
    }
    return "planned";
  };
  EXPECT_EQ(message(19'999), "planned");
  EXPECT_EQ(message(21'000),
            "motion.margin: 21000 m; makes a grid of 2.1e+08 cells; at most 200 million are allowed; make it "
            "smaller");
  EXPECT_THAT(message(1e300), testing::HasSubstr("motion.margin: 1e+300 m"));  // no number of 32 bits
}

TEST(Plan, TakesTheThreadsThatHaveEnoughToDo) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  mpm::Scene scene = samples::mortar_block(120, 120);
  EXPECT_EQ(mpm::plan(scene).threads, 1);
  scene.kinematics = mpm::Kinematics::moving;
  EXPECT_GE(mpm::plan(scene).threads, 1);
  EXPECT_LE(mpm::plan(scene).threads, std::min(cores, 5)) << "other programs may be busy";
  scene.threads = 7;
  EXPECT_EQ(mpm::plan(scene).threads, 7);
}

// However long the ramp, the run ends at the strain that was asked for.
TEST(Plan, StepsReachTheStrainWithinALongRamp) {
  mpm::Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  scene.loading.stop_strain = 1e-5;
  const double time = scene.loading.stop_strain * scene.height() / scene.loading.velocity;
  for (const double ramps : {0.5, 1.9, 2.1, 4.0, 40.0}) {
    scene.loading.ramp_time = ramps * time;
    const mpm::Plan plan = mpm::plan(scene);
    double displacement = 0;
    for (std::int64_t step = 0; step < plan.steps; ++step)
      displacement +=
          plan.dt * scene.loading.velocity * mpm::ramp(plan, (static_cast<double>(step) + 0.5) * plan.dt);
    const double wanted = scene.loading.stop_strain * scene.height();
    EXPECT_NEAR(displacement, wanted, plan.dt * scene.loading.velocity + 1e-6 * wanted) << ramps;
  }
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
  EXPECT_NEAR(mpm::plan(scene).ramp_time, 2 * mpm::plan(scene).transit_time, 1e-15);
  EXPECT_NEAR(mpm::plan(scene).wave_speed, mpm::wave_speed(*scene.phases[samples::itz], scene.plane), 1e-9);
  scene.loading.ramp_time = 3e-5;
  EXPECT_EQ(mpm::plan(scene).ramp_time, 3e-5);
}

// What cannot change its volume carries a wave that cannot strain sideways at no finite speed; the specimen
// answers no faster for that.
TEST(Plan, RampsAsLongAsTheSpecimenTakesToAnswer) {
  mpm::Scene scene = samples::mortar_block(40, 40);
  const double usual = mpm::plan(scene).ramp_time;
  EXPECT_NEAR(usual, 2 * 20e-3 / std::sqrt(20e9 / (1 - 0.04) / 2400), 1e-15);
  scene.phases[samples::mortar]->poisson = 0.4999;
  EXPECT_NEAR(mpm::plan(scene).ramp_time, 2 * 20e-3 / std::sqrt(20e9 / (1 - 0.4999 * 0.4999) / 2400), 1e-15);
  EXPECT_GT(mpm::plan(scene).ramp_time, 0.85 * usual);
  scene = samples::mortar_block(40, 400);
  EXPECT_NEAR(mpm::plan(scene).ramp_time, 10 * usual, 1e-14) << "a wide specimen swings sideways";
}

// Layers of equal thickness in series: their compliances add up.
TEST(Plan, TransitsInASoftLayerAreSlow) {
  mpm::Scene scene = samples::mortar_block(40, 40);
  scene.labels.topRows(20).setConstant(samples::aggregate);
  const double stiff = 40e9 / (1 - 0.04), soft = 20e9 / (1 - 0.04);
  EXPECT_NEAR(mpm::plan(scene).transit_time, 20e-3 * std::sqrt(2400 * 0.5 * (1 / stiff + 1 / soft)), 1e-15);
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

std::string message_of(const mpm::Scene& scene) {
  try {
    (void)mpm::plan(scene);
    return "planned";
  } catch (const mpm::Error& error) {
    return error.what();
  }
}

mpm::Scene softening_block(double pixel_size) {
  mpm::Scene scene = samples::mortar_block(20, 20, pixel_size);
  scene.phases[samples::mortar]->fracture_energy = 60;
  scene.phases[samples::mortar]->weibull_modulus = 1e9;
  return scene;
}

TEST(Plan, RefusesAPixelInWhichACrackWouldSnapBack) {
  // 2 E' G_f / f_t^2 = 2 x 20.8 GPa x 60 J/m2 / (15 MPa)^2 = 11.1 mm for a cell of two pixels.
  EXPECT_EQ(message_of(softening_block(5.5e-3)), "planned");
  EXPECT_EQ(
      message_of(softening_block(6e-3)),
      "phases.mortar.fracture_energy: 60 J/m2; is less than the elastic energy of a crack band of 12 mm at "
      "the strongest point, 15 MPa; use pixels of 5.55 mm at most, a larger weibull_modulus or a larger "
      "fracture_energy");
  mpm::Scene scattered = softening_block(1e-3);
  scattered.phases[samples::mortar]->weibull_modulus = 1.5;
  EXPECT_THAT(message_of(scattered), testing::HasSubstr("at the strongest point, "));
}

TEST(Plan, RefusesAPixelInWhichAShearBandWouldSnapBack) {
  mpm::Scene scene = softening_block(5e-3);
  scene.phases[samples::mortar]->fracture_energy = 0;
  scene.phases[samples::mortar]->shear_fracture_energy = 5e4;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  // 2 E' G / f_c^2 with f_c = 2 x 150 MPa cos 50 deg / (1 - sin 50 deg) = 824 MPa: 3.07 mm.
  EXPECT_EQ(
      message_of(scene),
      "phases.mortar.shear_fracture_energy: 5e+04 J/m2; is less than the elastic energy of a shear band of "
      "10 "
      "mm at the strongest point, 824 MPa; use pixels of 1.53 mm at most, a larger weibull_modulus or a "
      "larger shear_fracture_energy");
  scene.pixel_size = 1.5e-3;
  EXPECT_EQ(message_of(scene), "planned");
}

TEST(Plan, KnowsOverHowManyCellsACrackIsSmeared) {
  mpm::Scene scene = softening_block(1e-3);
  scene.kinematics = mpm::Kinematics::moving;
  EXPECT_EQ(mpm::plan(scene).moving.crack_band, 2e-3);
  scene.motion.shape = mpm::Shape::bspline;
  EXPECT_GT(mpm::plan(scene).moving.crack_band, 3e-3);
  scene.kinematics = mpm::Kinematics::automatic;
  EXPECT_THAT(message_of(scene), testing::StartsWith("motion.shape: bspline; smears a crack over two cells"));
}

}  // namespace plan_test
