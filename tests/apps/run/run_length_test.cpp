#include "apps/run/run_length.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "apps/text/complaint.hpp"

namespace run_length_test {

using testing::ContainsRegex;

mpm::Scene block(double velocity) {
  mpm::Scene scene;
  scene.labels.setConstant(8, 8, 1);
  scene.pixel_size = 1e-3;
  scene.pixel_cells = false;
  scene.points_per_cell = 2;
  scene.phases = {std::nullopt, mpm::concrete_phases()[0]};
  scene.loading.velocity = velocity;
  scene.threads = 1;
  return scene;
}

TEST(RunLength, IsSaidOfHalfAMillionSteps) {
  EXPECT_THAT(app::announcement(block(1e-5)),
              ContainsRegex("a run of 64 points and [0-9]+ steps of .* s, which takes about .* here"));
}

TEST(RunLength, IsNotSaidOfAShortRun) { EXPECT_EQ(app::announcement(block(0.05)), ""); }

TEST(RunLength, IsNotSaidOfEquilibriumWhichHasNoSteps) {
  mpm::Scene scene = block(1e-5);
  scene.method = mpm::SolverMethod::quasi_static;
  EXPECT_EQ(app::announcement(scene), "");
}

TEST(RunLength, OfRunsSideBySideIsSharedByTheWorkers) {
  const mpm::Scene scene = block(1e-5);
  const app::RunSize size = app::size_of(scene);
  EXPECT_EQ(size.points, 64);
  EXPECT_GT(size.steps, 500'000);
  const app::RunSize large{1'000'000, size.steps};
  const auto sample = [&] { return scene; };
  const double alone = app::time_of_runs({large}, sample, 2), four = app::time_of_runs({4, large}, sample, 2);
  EXPECT_GT(alone, 0);
  EXPECT_NEAR(four / alone, 2, 1.5);  // measured twice
}

TEST(RunLength, OfShortRunsIsNotMeasured) {
  const auto sample = []() -> mpm::Scene { throw std::logic_error("made for nothing"); };
  EXPECT_EQ(app::time_of_runs(std::vector<app::RunSize>(100, {64, 1000}), sample, 2), 0);
  EXPECT_EQ(app::time_of_runs({}, sample, 2), 0);
}

TEST(RunLength, IsAnUpperBoundWhereADropEndsTheRun) {
  mpm::Scene scene = block(1e-5);
  EXPECT_THAT(app::announcement(scene), testing::HasSubstr("which takes about "));
  scene.loading.stop_drop = 0.5;
  EXPECT_THAT(app::announcement(scene), testing::HasSubstr("which takes up to "));
}

TEST(RunLength, HasAUnitThatFits) {
  EXPECT_EQ(app::duration_text(42.4), "42 s");
  EXPECT_EQ(app::duration_text(720), "12 min");
  EXPECT_EQ(app::duration_text(12000), "3.3 h");
  EXPECT_EQ(app::duration_text(5 * 86400), "5 days");
}

TEST(RunLength, OfAPictureMustBeAskedForBeyondTenMinutes) {
  EXPECT_NO_THROW(app::refuse_unasked_length({599, "a run"}, 2592));
  try {
    app::refuse_unasked_length({19199, "a run of many points"}, 2592);
    FAIL() << "five hours that nobody has asked for";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::data);
    EXPECT_STREQ(rejected.what(),
                 "convert.pixels: auto, 2592 columns; a run of many points; runs of a picture of more than "
                 "10 min must be asked for; give --convert.pixels 648 for about 5 min, or --convert.pixels "
                 "2592 for all of it");
  }
}

TEST(RunLength, IsMeasuredInTime) {
  EXPECT_GT(app::length_of(block(1e-5)).seconds, 0);
  EXPECT_EQ(app::length_of(block(0.05)).seconds, 0);
}

}  // namespace run_length_test
