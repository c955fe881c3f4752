#include "libmpm/scene.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "libmpm/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace {

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

TEST(Validate, SaysWhatIsWrongAndHowToCureIt) {
  EXPECT_EQ(message_after([](Scene& s) { s.labels.setConstant(5, 4, 2); }),
            "specimen.labels: 4 x 5 pixels; width and height must be whole numbers of cells of 2 x 2 pixels; "
            "crop or resample the picture, or change solver.points_per_cell");
  EXPECT_EQ(message_after([](Scene& s) { s.labels.setConstant(4, 4, 0); }),
            "specimen.labels: all void; at least one pixel must be of a phase that carries load");
  EXPECT_EQ(message_after([](Scene& s) { s.labels(0, 0) = 9; }),
            "specimen.labels: 9; every label needs a phase");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.velocity = -0.05; }),
            "loading.velocity: -0.05 m/s; must be > 0; the direction is told by loading.direction");
  EXPECT_EQ(message_after([](Scene& s) { s.cfl = 1.05; }), "solver.cfl: 1.05; must lie in (0, 1]");
  EXPECT_EQ(message_after([](Scene& s) { s.points_per_cell = 5; }),
            "solver.points_per_cell: 5; must be 1, 2, 3 or 4");
  EXPECT_EQ(message_after([](Scene& s) { s.loading.stop_drop = 1.5; }),
            "loading.stop_drop: 1.5; must lie in (0, 1)");
  EXPECT_EQ(message_after([](Scene& s) { s.threads = 0; }), "solver.threads: 0; must lie in 1 ... 1024");
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
  EXPECT_EQ(message_after([](Scene& s) { s.phases[samples::mortar]->young = 0; }),
            "phases.mortar.young: 0 Pa; must be > 0");
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

TEST(Validate, RefusesNotANumber) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_after([](Scene& s) { s.pixel_size = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.velocity = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.ramp_time = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.loading.stop_strain = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.local_damping = nan; }), "valid");
  EXPECT_NE(message_after([](Scene& s) { s.cfl = nan; }), "valid");
}

}  // namespace
