#include "specimen/convert/classes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace thresholds_test {

using specimen::otsu_thresholds;
using specimen::Raster;

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

TEST(Thresholds, AreFewerThanAskedForWhereLevelsAreMissing) {
  EXPECT_EQ(otsu_thresholds(row({5, 5, 9}), 4), (std::vector<double>{7}));
  EXPECT_TRUE(otsu_thresholds(row({5, 5}), 3).empty());
}

}  // namespace thresholds_test
