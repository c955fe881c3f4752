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

mpm::Scene still(int pixels) {
  mpm::Scene scene = block(0.05);
  scene.labels.setConstant(pixels, pixels, 1);
  scene.phases[1] = mpm::concrete_phases()[1];
  scene.method = mpm::SolverMethod::quasi_static;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  return scene;
}

TEST(RunLength, IsNotSaidOfAShortRunWithoutInertia) { EXPECT_EQ(app::announcement(still(24)), ""); }

TEST(RunLength, IsSaidRoughlyOfALongRunWithoutInertia) {
  mpm::Scene scene = still(1000);
  scene.loading.direction = mpm::Direction::compression;
  EXPECT_THAT(app::announcement(scene),
              ContainsRegex("^a run of 1000000 points and roughly [0-9]+ states in equilibrium, which takes "
                            "roughly .* here$"));
  EXPECT_TRUE(app::size_of(scene).quasi_static);
}

TEST(RunLength, CountsNoStatesWhereNothingFails) {
  mpm::Scene scene = still(24);
  scene.phases[1]->tensile_scale = mpm::Phase::unbreakable;
  scene.phases[1]->cohesion = mpm::Phase::unbreakable;
  EXPECT_EQ(app::size_of(scene).steps, 1);
}

TEST(RunLength, OfRunsSideBySideIsSharedByTheWorkers) {
  const mpm::Scene scene = block(1e-5);
  const app::RunSize size = app::size_of(scene);
  EXPECT_EQ(size.points, 64);
  EXPECT_GT(size.steps, 500'000);
  const app::RunSize large{1'000'000, size.steps};
  const auto sample = [&](std::size_t) { return scene; };
  const double alone = app::time_of_runs({large}, sample, 2), four = app::time_of_runs({4, large}, sample, 2);
  EXPECT_GT(alone, 0);
  EXPECT_NEAR(four / alone, 2, 1.5);  // measured twice
}

TEST(RunLength, OfRunsWithAndWithoutInertiaIsThatOfBoth) {
  const mpm::Scene scene = block(1e-5), at_rest = still(24);
  const app::RunSize with{1'000'000, 500'000}, without{1'000'000, 500'000, true};
  std::vector<std::size_t> asked;
  const auto sample = [&](std::size_t i) {
    asked.push_back(i);
    return i == 1 ? scene : at_rest;
  };
  EXPECT_GT(app::time_of_runs({{64, 10}, with, {64, 10, true}, without}, sample, 1), 0);
  EXPECT_EQ(asked, (std::vector<std::size_t>{1, 3})) << "the largest of each method";
  EXPECT_EQ(app::size_text({with, without}),
            "1000000 points and 500000 steps or roughly 500000 states in equilibrium");
  EXPECT_STREQ(app::precision_word({with, without}, true), "roughly");
  EXPECT_STREQ(app::precision_word({with}, true), "up to");
  EXPECT_STREQ(app::precision_word({with}, false), "about");
}

TEST(RunLength, OfShortRunsIsNotMeasured) {
  const auto sample = [](std::size_t) -> mpm::Scene { throw std::logic_error("made for nothing"); };
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
