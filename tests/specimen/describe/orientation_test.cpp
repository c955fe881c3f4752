#include "specimen/describe/descriptors.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace orientation_test {

constexpr double pi = std::numbers::pi;

TEST(Orientation, OfParallelAxesIsTheirs) {
  for (const double angle : {0.0, 0.3, pi / 2, 3.0}) {
    const Orientation found = mean_orientation({{angle, 1}, {angle, 2}, {angle, 1}, {angle + pi, 1}});
    EXPECT_NEAR(found.direction, angle, 1e-12);
    EXPECT_NEAR(found.strength, 1, 1e-12);
    EXPECT_LT(found.probability, 0.05);
  }
}

TEST(Orientation, OfACrossIsNone) {
  std::vector<WeightedAxis> axes;
  for (int n = 0; n < 20; ++n) axes.push_back({0.4 + n % 2 * pi / 2, 1});
  const Orientation found = mean_orientation(axes);
  EXPECT_NEAR(found.strength, 0, 1e-12);
  EXPECT_NEAR(found.probability, 1, 1e-12);
}

TEST(Orientation, FollowsTheHeavierAxes) {
  const Orientation found = mean_orientation({{0, 3}, {pi / 2, 1}});
  EXPECT_NEAR(found.direction, 0, 1e-12);
  EXPECT_NEAR(found.strength, 0.5, 1e-12);
}

TEST(Orientation, OfNothingIsNone) {
  EXPECT_EQ(mean_orientation({}).strength, 0);
  EXPECT_EQ(mean_orientation({}).probability, 1);
  EXPECT_EQ(mean_orientation({{1, 0}}).probability, 1);
}

// One in twenty samples of random axes is found to have a direction at that level, by its definition.
TEST(Orientation, TakesRandomAxesForDirectedAsOftenAsItsLevelSays) {
  Random random(1);
  constexpr int trials = 4000;
  int directed = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<WeightedAxis> axes;
    for (int n = 0; n < 25; ++n) axes.push_back({random.uniform(0, pi), 1});
    directed += mean_orientation(axes).probability < 0.05;
  }
  EXPECT_NEAR(directed / static_cast<double>(trials), 0.05, 0.012);  // 3.5 standard deviations
}

TEST(Orientation, FindsAWeakDirectionOfManyAxes) {
  Random random(2);
  std::vector<WeightedAxis> axes;
  for (int n = 0; n < 400; ++n)
    axes.push_back({n % 4 == 0 ? random.uniform(0.9, 1.1) : random.uniform(0, pi), 1});
  const Orientation found = mean_orientation(axes);
  EXPECT_LT(found.probability, 1e-4);
  EXPECT_NEAR(found.direction, 1, 0.15);
  EXPECT_NEAR(found.strength, 0.25, 0.07);
}

TEST(Orientation, CountsAxesByTheirEffectiveNumber) {
  const Orientation three = mean_orientation({{0.1, 1}, {0.3, 1}, {1.2, 1}});
  const Orientation heavy = mean_orientation({{0.1, 100}, {0.3, 100}, {1.2, 100}, {0.7, 0}});
  EXPECT_NEAR(heavy.strength, three.strength, 1e-12);
  EXPECT_NEAR(heavy.probability, three.probability, 1e-12);
}

}  // namespace orientation_test
}  // namespace specimen
