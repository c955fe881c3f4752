#include "specimen/convert/classes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace classes_test {

using specimen::Clusters;
using specimen::find_clusters;
using specimen::otsu_thresholds;
using specimen::Position;
using specimen::Raster;
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

Raster<double> row(std::vector<double> values) {
  Raster<double> r(1, static_cast<int>(values.size()));
  r.data = std::move(values);
  return r;
}

double deviation(const std::vector<double>& values) {
  double mean = 0, sum = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum;
}

TEST(Thresholds, AValueThatReachesAThresholdIsAboveIt) {
  EXPECT_EQ(specimen::classes_between(row({0, 9.9, 10, 19, 20, 99}), {10, 20}).data,
            (std::vector<std::uint8_t>{0, 0, 1, 1, 2, 2}));
}

TEST(Thresholds, OtsuCutsBetweenTheHeaps) {
  EXPECT_EQ(otsu_thresholds(row({10, 11, 12, 200, 201}), 2), (std::vector<double>{106}));
  EXPECT_EQ(otsu_thresholds(row({0, 1, 50, 51, 52, 200, 201}), 3), (std::vector<double>{25.5, 126}));
}

TEST(Thresholds, OtsuIsAsGoodAsTryingAllCuts) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) values.push_back(static_cast<double>(random() % 24));
    const auto cost = [&](double t1, double t2) {
      std::vector<std::vector<double>> parts(3);
      for (const double v : values) parts[static_cast<std::size_t>((v >= t1) + (v >= t2))].push_back(v);
      return deviation(parts[0]) + deviation(parts[1]) + deviation(parts[2]);
    };
    double best = std::numeric_limits<double>::infinity();
    for (double a = 0.5; a < 23; ++a)
      for (double b = a + 1; b < 24; ++b) best = std::min(best, cost(a, b));
    const auto found = otsu_thresholds(row(values), 3);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(cost(found[0], found[1]), best, 1e-9);
  }
}

TEST(Thresholds, WorkOnSixteenBitsAndFractions) {
  const auto deep = otsu_thresholds(row({100, 300, 60000, 65535}), 2);
  EXPECT_GT(deep.front(), 300);
  EXPECT_LT(deep.front(), 60000);
  const auto small = otsu_thresholds(row({-0.2, -0.1, 0.8, 0.9}), 2);
  EXPECT_GT(small.front(), -0.1);
  EXPECT_LT(small.front(), 0.8);
}

TEST(Thresholds, DoNotDependOnTheUnit) {
  std::vector<double> bytes;
  for (int i = 0; i < 200; ++i) bytes.push_back(i * i % 251);
  for (const double unit : {16.0, 257.0}) {
    std::vector<double> values = bytes;
    for (double& v : values) v *= unit;
    const auto expected = otsu_thresholds(row(bytes), 3), found = otsu_thresholds(row(values), 3);
    ASSERT_EQ(found.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(found[i], unit * expected[i]);
  }
}

TEST(Thresholds, AreFewerThanAskedForWhereLevelsAreMissing) {
  EXPECT_EQ(otsu_thresholds(row({5, 5, 9}), 4), (std::vector<double>{7}));
  EXPECT_TRUE(otsu_thresholds(row({5, 5}), 3).empty());
}

}  // namespace classes_test
