#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/reproduce/figure.hpp"
#include "tests/apps/reproduce/tiny_effort.hpp"

namespace fig_weibull_test {

using namespace app::reproduce;
using testing::HasSubstr;

TEST(FigWeibull, MeasuresBothPhasesThatCanCrack) {
  const Section section = weibull_figure().evaluate(test::tiny_effort(), TrialResults());
  ASSERT_EQ(section.data.size(), 2U);
  const auto& mortar = section.data["mortar"];
  EXPECT_NEAR(mortar["mean_Pa"].get<double>(), 13.54e6,
              2e6);  // 15 MPa * Gamma(1 + 1 / 1.5), a few hundred points
  EXPECT_LT(mortar["distance"].get<double>(), mortar["critical_distance"].get<double>());
  EXPECT_EQ(section.claims.front().verdict, Verdict::agrees);
}

TEST(FigWeibull, FollowsTheSettingsOfTheEffort) {
  Effort effort = test::tiny_effort();
  effort.square.emplace_back("phases.mortar.weibull_modulus", "6");
  const Section section = weibull_figure().evaluate(effort, TrialResults());
  const auto& mortar = section.data["mortar"];
  EXPECT_NEAR(mortar["mean_Pa"].get<double>(), 13.92e6, 0.5e6);  // 15 MPa * Gamma(1 + 1 / 6)
  EXPECT_LT(mortar["distance"].get<double>(), mortar["critical_distance"].get<double>());
  EXPECT_THAT(section.html, HasSubstr("m = 6."));
}

}  // namespace fig_weibull_test
