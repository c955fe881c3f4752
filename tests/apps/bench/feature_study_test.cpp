#include "apps/bench/feature_study.hpp"

#include <gtest/gtest.h>

#include "libmpm/run/simulate.hpp"

namespace feature_study_test {

using namespace app::bench;

TEST(FeatureStudy, LeavesNothingOutThatChangesResults) {
  const std::vector<FeatureCase> cases = all_features(60);
  const auto costs = measure_features(cases, 1, {}, {});
  ASSERT_EQ(costs.size(), 13U);
  for (const FeatureCost& cost : costs) {
    EXPECT_TRUE(cost.agrees()) << cost.feature << ", " << cost.kinematics << ": " << cost.difference;
    EXPECT_GT(cost.time_with, 0);
    EXPECT_GT(cost.time_without, 0);
  }
}

// A test of failing points that nothing reaches proves nothing.
TEST(FeatureStudy, PointsFailInTheScenesThatLetThem) {
  for (const FeatureCase& it : all_features(60))
    if (it.feature == "shear test" || it.feature == "local damping") {
      EXPECT_GT(mpm::simulate(it.make()).tension_failures, 50) << it.kinematics;
    }
}

// A "feature" that changes the physics must not pass for one that may be left out.
TEST(FeatureStudy, SeesWhatChangesResults) {
  FeatureCase it = all_features(60).front();
  it.add = [](mpm::Plan& plan) { plan.dt *= 0.5; };
  EXPECT_FALSE(measure_features({it}, 1, {}, {}).at(0).agrees());
  FeatureCase failing = all_features(60).at(3);
  ASSERT_EQ(failing.feature, "local damping");
  failing.add = [](mpm::Plan& plan) { plan.ramp_time *= 2; };
  EXPECT_FALSE(measure_features({failing}, 1, {}, {}).at(0).agrees());
}

TEST(FeatureStudy, StopsWhenItIsTold) {
  std::size_t told = 0;
  const auto costs = measure_features(
      all_features(60), 1, [&](std::size_t done, std::size_t) { told = done; }, [&] { return told < 2; });
  EXPECT_EQ(costs.size(), 2U);
}

}  // namespace feature_study_test
