#include "specimen/convert/classes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace clusters_test {

using specimen::Clusters;
using specimen::find_clusters;
using specimen::Position;
using specimen::WeightedPoint;

std::vector<WeightedPoint> crowds() {
  std::vector<WeightedPoint> points;
  for (const Position& middle : {Position{0, 0, 0, 0}, Position{50, 0, 0, 0}, Position{0, 50, 0, 50}})
    for (int i = -3; i <= 3; ++i)
      for (std::size_t d = 0; d < 4; ++d) {
        WeightedPoint p{middle, 1};
        p.at[d] += i;
        points.push_back(p);
      }
  return points;
}

TEST(Clusters, FindsTheMiddlesOfCrowds) {
  Clusters found = find_clusters(crowds(), 3);
  std::sort(found.centres.begin(), found.centres.end());
  ASSERT_EQ(found.centres.size(), 3U);
  EXPECT_EQ(found.centres[0], (Position{0, 0, 0, 0}));
  EXPECT_EQ(found.centres[1], (Position{0, 50, 0, 50}));
  EXPECT_EQ(found.centres[2], (Position{50, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(found.spread, 3 * 4 * (9 + 4 + 1) * 2);
}

TEST(Clusters, GivesTheSameAnswerEveryTime) {
  const auto points = crowds();
  EXPECT_EQ(find_clusters(points, 5).centres, find_clusters(points, 5).centres);
}

TEST(Clusters, WeightsPullTheCentre) {
  const Clusters found = find_clusters({{{0, 0, 0, 0}, 3}, {{4, 0, 0, 0}, 1}}, 1);
  EXPECT_EQ(found.centres, (std::vector<Position>{{1, 0, 0, 0}}));
}

TEST(Clusters, HasNoMoreCentresThanDistinctPoints) {
  EXPECT_EQ(find_clusters({{{1, 2, 3, 0}, 5}, {{4, 5, 6, 0}, 1}}, 7).centres.size(), 2U);
  EXPECT_TRUE(find_clusters({}, 3).centres.empty());
}

TEST(Clusters, NearestTakesTheFirstOfEquals) {
  EXPECT_EQ(specimen::nearest({{0, 0, 0, 0}, {2, 0, 0, 0}}, {1, 0, 0, 0}), 0);
  EXPECT_EQ(specimen::nearest({{0, 0, 0, 0}, {2, 0, 0, 0}}, {1.5, 0, 0, 0}), 1);
}

}  // namespace clusters_test
