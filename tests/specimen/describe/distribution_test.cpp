#include "specimen/describe/aggregate_sample.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace specimen {
namespace distribution_test {

TEST(Distribution, RisesByTheWeightsOfItsValues) {
  const Distribution distribution = distribution_of({{4, 1}, {2, 0.75}, {2, 0.25}});
  ASSERT_EQ(distribution.value, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(distribution.below[0], 0.5);
  EXPECT_DOUBLE_EQ(distribution.below[1], 1);
  EXPECT_EQ(share_up_to(distribution, 1.9), 0);
  EXPECT_DOUBLE_EQ(share_up_to(distribution, 2), 0.5);
  EXPECT_DOUBLE_EQ(share_up_to(distribution, 3.9), 0.5);
  EXPECT_EQ(share_up_to(distribution, 5), 1);
  EXPECT_EQ(quantile(distribution, 0.4), 2);
  EXPECT_EQ(quantile(distribution, 0.6), 4);
  EXPECT_EQ(quantile(distribution, 1), 4);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_EQ(share_up_to({}, 1), 0);
}

TEST(Distribution, OfSeveralSamplesGivesEachTheSameSay) {
  const PooledDistribution pool({{{2, 1}}, {{4, 1}, {4, 7}}, {}});
  ASSERT_EQ(pool.all().value, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(pool.all().below[0], 0.5);
  EXPECT_DOUBLE_EQ(pool.without(2).below[0], 0.5);
  EXPECT_EQ(pool.without(0).value, (std::vector<double>{4}));
  EXPECT_TRUE(PooledDistribution({{{2, 1}}}).without(0).value.empty());
}

TEST(Distribution, LiesApartByTheLargestAndTheMeanDifference) {
  const Distribution first{{1, 2}, {0.4, 1}}, second{{1, 3}, {0.1, 1}};
  const DistributionDistance distance = distance_between(first, second);
  EXPECT_DOUBLE_EQ(distance.largest, 0.9);
  EXPECT_DOUBLE_EQ(distance.mean, 0.3 + 0.9);
  EXPECT_EQ(distance_between(first, first).largest, 0);
  EXPECT_EQ(distance_between(first, first).mean, 0);
  EXPECT_TRUE(std::isnan(distance_between(first, {}).largest));
}

}  // namespace distribution_test
}  // namespace specimen
