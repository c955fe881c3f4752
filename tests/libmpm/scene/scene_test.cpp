#include "libmpm/scene/scene.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace scene_test {

using mpm::Scene;

std::string message_after(const std::function<void(Scene&)>& change) {
  Scene scene = samples::mortar_block(4, 4);
  change(scene);
  try {
    mpm::validate(scene);
  } catch (const mpm::Error& error) {
    return error.what();
  }
  return "valid";
}

TEST(Validate, AcceptsTheSample) {
  EXPECT_EQ(message_after([](Scene&) {}), "valid");
}

// Before a platen that is faster than waves, strain would exceed 1. The bar wave of mortar: 2946.3 m/s.
TEST(Validate, RefusesAPlatenThatOutrunsItsWave) {
  const auto at = [](double velocity, mpm::SolverMethod method = mpm::SolverMethod::explicit_) {
    return message_after([=](Scene& s) {
      s.loading.velocity = velocity;
      s.method = method;
    });
  };
  EXPECT_EQ(at(1e30),
            "loading.velocity: 1e+30 m/s; must be below 2946.28 m/s, the speed of a wave in mortar, which no "
            "platen outruns; load more slowly");
  EXPECT_EQ(at(2940), "valid");
  EXPECT_EQ(at(1e30, mpm::SolverMethod::quasi_static), "valid") << "there is no rate";
  EXPECT_NE(message_after([](Scene& s) { s.phases[samples::mortar]->density = 1e14; }), "valid");
}

TEST(Validate, SaysWhatIsWrongAndHowToCureIt) {
  EXPECT_EQ(message_after([](Scene& s) { s.labels.setConstant(5, 4, 2); }),
            "specimen.labels: 4 x 5 pixels; width and height must be whole numbers of cells of 2 x 2 pixels; "
            "crop or resample the picture, or change solver.cell");
  EXPECT_EQ(message_after([](Scene& s) { s.labels.setConstant(4, 4, 0); }),
            "specimen.labels: all void; at least one pixel must be of a phase that carries load");
  EXPECT_EQ(message_after([](Scene& s) { s.labels(0, 0) = 9; }),
            "specimen.labels: 9; every label needs a phase");
  EXPECT_EQ(message_after([](Scene& s) { s.phases[2]->shear_fracture_energy = 900; }),
            "phases.mortar.shear_fracture_energy: 900 J/m2; needs damage.crack_closure; choose "
            "damage.crack_closure = \"unilateral\"");
  EXPECT_EQ(message_after([](Scene& s) { s.phases[2]->softening = mpm::SofteningCurve::hordijk; }),
            "phases.mortar.softening: hordijk; needs a fracture_energy");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.velocity = -0.05; }),
            "loading.velocity: -0.05 m/s; must be > 0; loading.direction sets the direction");
  EXPECT_EQ(message_after([](Scene& s) { s.cfl = 1.05; }), "solver.cfl: 1.05; must lie in (0, 1]");
  EXPECT_EQ(message_after([](Scene& s) { s.points_per_cell = 5; }),
            "solver.cell: 5 points along an edge; must be 1, 2, 3 or 4");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.stop_drop = 1.5; }),
            "loading.stop_drop: 1.5; must lie in (0, 1)");
  EXPECT_EQ(message_after([](Scene& s) { s.threads = -1; }),
            "solver.threads: -1; must lie in [1, 1024], or 0 for a number chosen automatically");
  EXPECT_EQ(message_after([](Scene& s) {
              s.extra_points.push_back({1, 0, 3});
            }),
            "specimen.extra_points: (1 m, 0 m); must lie inside the specimen");
  EXPECT_EQ(message_after([](Scene& s) { s.damage.residual_stiffness = 1; }),
            "damage.residual_stiffness: 1; must lie in [0, 1)");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.stop_strain = 1; }),
            "loading.stop_strain: 1; must lie in (0, 1)");
  EXPECT_EQ(message_after([](Scene& s) { s.local_damping = 1; }),
            "solver.local_damping: 1; must lie in [0, 1)");
  EXPECT_EQ(message_after([](Scene& s) { s.history_rows = 9; }), "output.history_rows: 9; must be >= 10");
  EXPECT_EQ(message_after([](Scene& s) { s.frames = -1; }), "output.frames: -1; must be >= 0");
  EXPECT_EQ(message_after([](Scene& s) { s.phases[samples::mortar]->young = 0; }),
            "phases.mortar.young: 0 Pa; must be > 0");
}

TEST(Faults, AreToldAllAtOnce) {
  Scene scene = samples::mortar_block(4, 4);
  EXPECT_TRUE(mpm::faults(scene).empty());
  scene.labels(0, 0) = samples::itz;
  scene.phases[samples::mortar]->young = 0;
  scene.phases[samples::itz]->poisson = 0.5;
  scene.loading.stop_strain = 1;
  scene.cfl = 2;
  std::vector<std::string> fields;
  for (const mpm::Error& fault : mpm::faults(scene)) fields.push_back(fault.field);
  EXPECT_EQ(fields, (std::vector<std::string>{"phases.mortar.young", "phases.itz.poisson",
                                              "loading.stop_strain", "solver.cfl"}));
  EXPECT_EQ(mpm::faults_beside_specimen(scene).size(), 2u);
  EXPECT_EQ(mpm::faults(*scene.phases[samples::mortar], scene.plane).size(), 1u);
}

TEST(Validate, WantsWholeCellsBothWays) {
  EXPECT_NE(message_after([](Scene& s) { s.labels.setConstant(5, 4, 2); }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.labels.setConstant(4, 5, 2); }), "valid");
  EXPECT_EQ(message_after([](Scene& s) {
              s.points_per_cell = 3;
              s.labels.setConstant(6, 9, 2);
            }),
            "valid");
}

TEST(Validate, WantsExtraPointsOnOrWithinEveryEdge) {
  const auto with_point = [](double x, double y) {
    return message_after([=](Scene& s) { s.extra_points.push_back({x, y, 3}); });
  };
  for (const double inside : {0.0, 1e-3, 2e-3}) {
    EXPECT_EQ(with_point(inside, 1e-3), "valid");
    EXPECT_EQ(with_point(1e-3, inside), "valid");
  }
  for (const double outside : {-1e-9, 2.001e-3}) {
    EXPECT_NE(with_point(outside, 1e-3), "valid");
    EXPECT_NE(with_point(1e-3, outside), "valid");
  }
}

TEST(Validate, AsksNothingOfPhasesThatDoNotOccur) {
  EXPECT_EQ(message_after([](Scene& s) { s.phases[samples::aggregate]->young = 0; }), "valid");
}

/// A change to a scene without platens that is else valid.
std::string message_in_flight(const std::function<void(Scene&)>& change) {
  return message_after([&](Scene& scene) {
    scene.kinematics = mpm::Kinematics::moving;
    scene.loading.direction = mpm::Direction::none;
    scene.loading.initial_velocity_y = -10;
    scene.loading.duration = 1e-3;
    change(scene);
  });
}

TEST(Validate, AcceptsASpecimenInFlightAndAtWalls) {
  EXPECT_EQ(message_in_flight([](Scene&) {}), "valid");
  EXPECT_EQ(message_in_flight([](Scene& s) {
              s.motion.left = mpm::Edge::symmetry;
              s.motion.right = mpm::Edge::open;
              s.motion.bottom = mpm::Edge::smooth_wall;
              s.motion.top = mpm::Edge::rough_wall;
            }),
            "valid");
}

TEST(Validate, AsksWithoutPlatensForMovingPointsAndADuration) {
  EXPECT_EQ(message_in_flight([](Scene& s) { s.kinematics = mpm::Kinematics::automatic; }),
            "loading.direction: none; free flight needs moving points; choose solver.kinematics moving");
  EXPECT_EQ(message_in_flight([](Scene& s) { s.loading.duration = 0; }),
            "loading.duration: 0 s; must be > 0; without platens it sets the end of the run");
  EXPECT_EQ(
      message_in_flight([](Scene& s) { s.loading.separation = true; }),
      "loading.separation: true; there are no platens to separate from; choose a wall in motion.bottom or "
      "motion.top");
}

TEST(Validate, RefusesWhatPlatensWouldIgnore) {
  EXPECT_EQ(message_after([](Scene& s) { s.loading.initial_velocity_y = -3; }),
            "loading.initial_velocity_y: -3 m/s; with platens the specimen starts at rest; choose "
            "loading.direction none");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.duration = 1; }),
            "loading.duration: 1 s; with platens a run ends at loading.stop_strain; choose "
            "loading.direction none");
  EXPECT_EQ(message_after([](Scene& s) {
              s.kinematics = mpm::Kinematics::moving;
              s.motion.top = mpm::Edge::smooth_wall;
            }),
            "motion.top: smooth_wall; there is a platen; choose loading.direction none");
}

TEST(Validate, PlatensThatPullMustHoldTheSpecimen) {
  EXPECT_EQ(message_after([](Scene& s) {
              s.kinematics = mpm::Kinematics::moving;
              s.loading.separation = true;
            }),
            "loading.separation: true; platens that pull must hold the specimen; choose loading.direction "
            "compression");
}

TEST(Validate, RefusesWhatSmallStrainWouldIgnore) {
  const auto parting = [](Scene& s) {
    s.loading.direction = mpm::Direction::compression;
    s.loading.separation = true;
  };
  EXPECT_EQ(message_after(parting),
            "loading.separation: true; is for moving points; choose solver.kinematics moving or auto");
  EXPECT_EQ(message_after([&](Scene& s) {
              parting(s);
              s.kinematics = mpm::Kinematics::automatic;
            }),
            "valid");
  EXPECT_EQ(message_after([](Scene& s) { s.motion.left = mpm::Edge::open; }),
            "motion.left: open; is for moving points; choose solver.kinematics moving");
  EXPECT_EQ(message_after([](Scene& s) {
              s.kinematics = mpm::Kinematics::automatic;
              s.motion.left = mpm::Edge::open;
            }),
            "valid");
  EXPECT_EQ(message_after([](Scene& s) {
              s.kinematics = mpm::Kinematics::automatic;
              s.motion.right = mpm::Edge::symmetry;
            }),
            "motion.right: symmetry; is for moving points; choose solver.kinematics moving");
}

TEST(Validate, KeepsTheNumbersOfMovingPointsInTheirRanges) {
  EXPECT_EQ(message_after([](Scene& s) { s.motion.flip_ratio = 1.5; }),
            "motion.flip_ratio: 1.5; must lie in [0, 1]");
  EXPECT_EQ(message_after([](Scene& s) {
              s.motion.transfer = mpm::Transfer::apic;
              s.motion.flip_ratio = 0.9;
            }),
            "motion.flip_ratio: 0.9; has no effect with motion.transfer apic; choose one of them");
  EXPECT_EQ(message_after([](Scene& s) { s.handover.strain = 0; }), "handover.strain: 0; must be > 0");
  EXPECT_EQ(message_after([](Scene& s) { s.handover.displacement = -1; }),
            "handover.displacement: -1; must be > 0");
}

TEST(Validate, RefusesNotANumber) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_after([](Scene& s) { s.pixel_size = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.velocity = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.ramp_time = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.stop_strain = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.local_damping = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.cfl = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.motion.flip_ratio = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.motion.margin = nan; }), "valid");
  EXPECT_EQ(message_after([](Scene& s) { s.damage.correlation_length = 1e-300; }),
            "damage.correlation_length: 1e-300 m; must be more than a billionth of the specimen; omit it "
            "for independent points");
  EXPECT_NE(message_after([](Scene& s) { s.handover.strain = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.handover.displacement = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.initial_velocity_x = nan; }), "valid");
  EXPECT_NE(message_in_flight([](Scene& s) { s.loading.initial_velocity_x = nan; }), "valid");
  EXPECT_NE(message_in_flight([](Scene& s) { s.loading.initial_velocity_y = nan; }), "valid");
  EXPECT_NE(message_in_flight([](Scene& s) { s.loading.duration = nan; }), "valid");
}

}  // namespace scene_test
