#include "apps/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace statistics_test {

using namespace app;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

TEST(Statistics, SpreadOfASample) {
  const Spread spread = spread_of({2, 4, 6, no_number});
  EXPECT_DOUBLE_EQ(spread.mean, 4);
  EXPECT_DOUBLE_EQ(spread.deviation, 2);  // sqrt((4 + 0 + 4) / 2)
  EXPECT_DOUBLE_EQ(spread.low, 2);
  EXPECT_DOUBLE_EQ(spread.high, 6);
  EXPECT_DOUBLE_EQ(spread_of({5}).deviation, 0);
  EXPECT_TRUE(std::isnan(spread_of({no_number}).mean));
}

TEST(Statistics, RankCorrelationSeesTheOrderAlone) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 6}, {1, 10, 11, 1000}), 1);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 6}, {9, 8, 7, -5}), -1);
  EXPECT_NEAR(rank_correlation({1, 2, 3, 4, 5}, {1, 2, 3, 5, 4}), 0.9, 1e-12);  // 1 - 6 * 2 / (5 * 24)
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3}, {4, 4, 4}), 0);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2}, {1, no_number})));
}

TEST(Statistics, PowerOfAPowerLaw) {
  EXPECT_NEAR(power_of({1, 2, 4}, {3, 3 * std::sqrt(2), 6}), 0.5, 1e-12);
  EXPECT_NEAR(power_of({1, 2, 4}, {7, 7, 7}), 0, 1e-12);
}

TEST(Statistics, ShareWithinIncludesTheEnds) {
  EXPECT_DOUBLE_EQ(share_within({1, 2, 3, 4}, 2, 3), 0.5);
  EXPECT_TRUE(std::isnan(share_within({}, 0, 1)));
}

TEST(Statistics, EqualValuesShareTheirRank) {
  EXPECT_NEAR(rank_correlation({1, 1, 2, 2}, {3, 4, 5, 6}), std::sqrt(0.8), 1e-12);  // by hand
}

TEST(Statistics, QuantilesLieBetweenValues) {
  EXPECT_DOUBLE_EQ(quantile_of({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile_of({4, 1, 3, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(quantile_of({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile_of({0, 10}, 0.1), 1);
  EXPECT_TRUE(std::isnan(quantile_of({}, 0.5)));
}

TEST(Confidence, IntervalIsStudents) {
  const MeanEstimate estimate = mean_estimate({1, 2, 3, 4, 5, std::nan("")});
  EXPECT_EQ(estimate.count, 5U);
  EXPECT_DOUBLE_EQ(estimate.mean, 3);
  EXPECT_NEAR(estimate.deviation, std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(estimate.half_width, 2.776445 * std::sqrt(2.5 / 5),
              1e-5);  // t of 4 degrees of freedom, in any table
  EXPECT_NEAR(estimate.relative_half_width(), estimate.half_width / 3, 1e-12);
}

TEST(Confidence, OneValueTellsNothingOfItsScatter) {
  EXPECT_TRUE(std::isnan(mean_estimate({2}).half_width));
  EXPECT_TRUE(std::isnan(mean_estimate({}).mean));
  EXPECT_EQ(values_needed(mean_estimate({2}), 0.02), 0U);
}

TEST(Confidence, NeedsTheLeastNumberThatIsEnough) {
  const MeanEstimate estimate{30, 10, 1, 0.37};
  // n = 97 of a normal distribution with 10 % scatter and 2 %; Student's factor asks for two more.
  const std::size_t needed = values_needed(estimate, 0.02);
  EXPECT_EQ(needed, 99U);
  EXPECT_EQ(values_needed({5, 10, 0, 0}, 0.02), 2U);
}

}  // namespace statistics_test
