#include "apps/report/run_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace run_words_test {

using testing::HasSubstr;
using testing::Not;

mpm::Scene falling() {
  mpm::Scene scene;
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading.direction = mpm::Direction::none;
  scene.loading.initial_velocity_x = 3;
  scene.loading.initial_velocity_y = -4;
  return scene;
}

TEST(LoadWords, TellOfPlatens) {
  mpm::Scene scene;
  EXPECT_TRUE(output::has_platens(scene));
  EXPECT_EQ(output::name_of_loading(scene), "tension");
  EXPECT_EQ(output::setting_of_loading(scene), "tension at 0.05 m/s, smooth platens");
  scene.loading.direction = mpm::Direction::compression;
  scene.loading.platen = mpm::Platen::rough;
  scene.loading.separation = true;
  EXPECT_EQ(output::setting_of_loading(scene), "compression at 0.05 m/s, rough platens with separation");
  EXPECT_EQ(output::name_of_strain(scene), "platen strain");
  EXPECT_THAT(output::meaning_of_curve(scene), HasSubstr("mean of the reactions of both platens"));
}

TEST(LoadWords, TellOfFlightAndWalls) {
  mpm::Scene scene = falling();
  EXPECT_FALSE(output::has_platens(scene));
  EXPECT_EQ(output::setting_of_loading(scene), "flight at 5 m/s");
  scene.motion.bottom = mpm::Edge::smooth_wall;
  scene.motion.right = mpm::Edge::rough_wall;
  scene.motion.left = mpm::Edge::symmetry;
  EXPECT_EQ(output::setting_of_loading(scene),
            "impact at 5 m/s, smooth wall at the bottom, rough wall at the right");
}

TEST(LoadWords, SayThatStressAndStrainAreNominalWithoutPlatens) {
  EXPECT_EQ(output::name_of_strain(falling()), "nominal strain");
  EXPECT_EQ(output::name_of_stress(falling()), "stress on the walls");
  EXPECT_THAT(output::meaning_of_curve(falling()), HasSubstr("reaction of the lower edge"));
  EXPECT_THAT(output::meaning_of_curve(falling()), Not(HasSubstr("platens over")));
}

TEST(LoadWords, SayWhereTheEnergyOfMovingPointsIsMissing) {
  mpm::Scene scene;
  EXPECT_THAT(output::meaning_of_energy(scene), Not(HasSubstr("dissipation")));
  scene.kinematics = mpm::Kinematics::automatic;
  EXPECT_THAT(output::meaning_of_energy(scene), HasSubstr("numerical dissipation"));
  scene.local_damping = 0.1;
  EXPECT_THAT(output::meaning_of_energy(scene), HasSubstr("points and damped energy."));
  scene.method = mpm::SolverMethod::quasi_static;
  EXPECT_THAT(output::meaning_of_energy(scene),
              HasSubstr("is the sum of elastic energy and energy released by failing points."));
}

TEST(LoadWords, NameTheKinematics) {
  mpm::Scene scene;
  EXPECT_EQ(output::name_of_kinematics(scene), "small strain");
  scene.kinematics = mpm::Kinematics::moving;
  EXPECT_EQ(output::name_of_kinematics(scene), "moving points (GIMP, MUSL, FLIP)");
  scene.kinematics = mpm::Kinematics::automatic;
  scene.motion.shape = mpm::Shape::bspline;
  scene.motion.scheme = mpm::Scheme::usl;
  scene.motion.flip_ratio = 0.95;
  EXPECT_EQ(output::name_of_kinematics(scene),
            "small strain, then moving points (B-spline, USL, 95.0\u00a0% FLIP)");
  scene.motion.transfer = mpm::Transfer::apic;
  EXPECT_THAT(output::name_of_kinematics(scene), HasSubstr("APIC"));
}

TEST(NoPeak, SaysHowTheRunEndedAndWhatToDo) {
  mpm::Scene scene;
  mpm::Result result;
  const auto go_to = [&](double strain, double stress) {
    mpm::HistoryRow row;
    row.strain = strain;
    row.stress = stress;
    result.history.push_back(row);
  };
  go_to(0, 0);
  EXPECT_THAT(output::no_peak_text(result, scene), HasSubstr("the stress never rose above 0"));
  go_to(1e-4, 3e6);
  result.peak_stress = 3e6;
  result.peak_strain = 1e-4;
  EXPECT_EQ(output::no_peak_text(result, scene),
            "no peak was reached: the stress was still rising at stop_strain, 100e-6, to 3.000 MPa; choose a "
            "larger loading.stop_strain");
  go_to(1.1e-4, 2.94e6);
  EXPECT_THAT(output::no_peak_text(result, scene), HasSubstr("had fallen by no more than 2.0"));
  result.stop = mpm::StopReason::interrupted;
  EXPECT_THAT(output::no_peak_text(result, scene), HasSubstr("when the run ended"));
  go_to(1.2e-4, 1e6);
  EXPECT_EQ(output::no_peak_text(result, scene), "");
  result.history.pop_back();
  EXPECT_EQ(output::no_peak_text(result, falling()), "") << "a flight that hits nothing has none";
}

}  // namespace run_words_test
