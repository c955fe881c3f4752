#include "apps/bench/feature_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libmpm/run/simulate.hpp"

namespace feature_study_test {

using namespace app::bench;
using testing::HasSubstr;

TEST(FeatureStudy, LeavesNothingOutThatChangesResults) {
  const std::vector<FeatureCase> cases = all_features(60);
  const auto costs = measure_features(cases, 1, {});
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
  EXPECT_FALSE(measure_features({it}, 1, {}).at(0).agrees());
  FeatureCase failing = all_features(60).at(3);
  ASSERT_EQ(failing.feature, "local damping");
  failing.add = [](mpm::Plan& plan) { plan.ramp_time *= 2; };
  EXPECT_FALSE(measure_features({failing}, 1, {}).at(0).agrees());
}

TEST(FeatureStudy, StopsWhenItIsTold) {
  std::size_t told = 0;
  const auto costs = measure_features(
      all_features(60), 1, {[&](std::size_t done, std::size_t) { told = done; }, [&] { return told < 2; }});
  EXPECT_EQ(costs.size(), 2U);
}

const std::vector<FeatureCost>& costs() {
  static const std::vector<FeatureCost> all{
      {"shear test", "small strain", "nothing can fail in shear", 1.25e-9, 1.5e-9, 3e-12, true, 1e-9},
      {"damping", "moving points", "nothing is damped", 12e-9, 15e-9, 0.02, true, 1e-9},
      {"closure", "moving points", "nothing can crack", 12e-9, 15e-9, 0, false, 1e-9}};
  return all;
}

TEST(FeatureReport, GivesTimesAndAgreement) {
  EXPECT_THAT(feature_text(costs()),
              HasSubstr("shear test               small strain       1.25     1.50    +0.25   to 3"));
  const std::string html = feature_html(costs());
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">shear test, small strain</th><td>nothing can fail in "
                              "shear</td><td>1.25</td><td>1.50</td><td>20.0\u00A0%</td>"));
  EXPECT_THAT(feature_csv(costs()),
              HasSubstr("shear test,small strain,nothing can fail in shear,1.25e-09,1.5e-09,3e-12,1,1\n"));
}

TEST(FeatureReport, HidesNoDisagreement) {
  EXPECT_THAT(feature_text(costs()), HasSubstr("NO: off by 0.02"));
  EXPECT_THAT(feature_text(costs()), HasSubstr("NO: other points fail"));
  EXPECT_THAT(feature_html(costs()), HasSubstr("NO: other points fail"));
  EXPECT_THAT(feature_csv(costs()), HasSubstr(",0.02,1,0\n"));
  EXPECT_THAT(feature_csv(costs()), HasSubstr(",0,0,0\n"));
}

}  // namespace feature_study_test
