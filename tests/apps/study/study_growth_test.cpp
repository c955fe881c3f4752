#include "apps/study/study_growth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace study_growth_test {

using namespace app;
using testing::ElementsAre;

TEST(StudyGrowth, EnoughIsEnough) {
  const MeanEstimate narrow{20, 100, 4, 1.9};
  EXPECT_EQ(seeds_to_go_on_with({narrow}, 20, 0.02), 20U);
  EXPECT_EQ(seeds_to_go_on_with({narrow}, 5, 0.02), least_seeds);
}

TEST(StudyGrowth, TakesWhatTheScatterCallsForAtMostTwiceAsMany) {
  const MeanEstimate wide{20, 100, 10, 4.68}, narrow{20, 100, 1, 0.468};
  EXPECT_EQ(seeds_to_go_on_with({narrow, wide}, 20, 0.04), values_needed(wide, 0.04));
  EXPECT_EQ(seeds_to_go_on_with({wide}, 20, 0.01), 40U);
  EXPECT_EQ(seeds_to_go_on_with({MeanEstimate{1, 100, 0, std::nan("")}}, 20, 0.02), 40U);
  EXPECT_EQ(seeds_to_go_on_with({wide}, most_seeds, 0.0001), most_seeds);
}

TEST(StudyGrowth, SeedsFollowTheLargest) {
  EXPECT_THAT(grown_seeds({9, 4}, 4), ElementsAre(9, 4, 10, 11));
  EXPECT_THAT(grown_seeds({1, 2}, 2), ElementsAre(1, 2));
}

TEST(StudyGrowth, PointsAreEstimatedOnTheirOwn) {
  StudyResults results;
  std::vector<Member> members;
  for (std::size_t i = 0; i < 6; ++i) {
    members.push_back({i, i % 2, {}, i / 2});
    results.outcomes.emplace_back().state = i == 5 ? MemberState::failed : MemberState::done;
    results.outcomes.back().figures.peak_stress = i % 2 == 0 ? 10.0 + static_cast<double>(i) : 7;
  }
  const auto estimates = peak_estimates(members, results);
  ASSERT_EQ(estimates.size(), 2U);
  EXPECT_EQ(estimates[0].mean, 12);
  EXPECT_EQ(estimates[0].count, 3U);
  EXPECT_EQ(estimates[1].mean, 7);
  EXPECT_EQ(estimates[1].count, 2U);
  EXPECT_EQ(largest_half_width(estimates), estimates[0].relative_half_width());
}

}  // namespace study_growth_test
