#include "apps/statistics/influences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/study/study_members.hpp"
#include "specimen/body/raster.hpp"

namespace influences_test {

using namespace app;

/// Ishigami and Homma (1990), with the usual a = 7, b = 0.1.
double ishigami(const std::vector<double>& u) {
  const auto x = [&](std::size_t i) { return std::numbers::pi * (2 * u[i] - 1); };
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

TEST(Sensitivity, FirstOrderIndicesOfIshigami) {
  const auto points = sobol_points(3, 4095);
  std::vector<double> y;
  for (const auto& point : points) y.push_back(ishigami(point));
  const double exact[] = {0.3139, 0.4424, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> x;
    for (const auto& point : points) x.push_back(point[axis]);
    EXPECT_NEAR(first_order_index(x, y), exact[axis], 0.02) << axis;
  }
}

TEST(Sensitivity, LevelsAreClasses) {
  EXPECT_NEAR(first_order_index({1, 1, 2, 2, 3, 3, 1, 2, 3}, {5, 5, 7, 7, 1, 1, 5, 7, 1}), 1, 1e-12);
  std::vector<double> x, y;
  for (int i = 0; i < 400; ++i) {
    x.push_back(i % 4);
    y.push_back(i / 4 % 5);  // each with each: no influence
  }
  EXPECT_NEAR(first_order_index(x, y), 0, 0.01);
}

TEST(Sensitivity, WithoutInfluenceTheIndexIsZeroOnAverage) {
  specimen::Random random(3);
  constexpr int repeats = 200;
  double mean = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::vector<double> x, y;
    for (int i = 0; i < 64; ++i) {
      x.push_back(random.uniform());
      y.push_back(random.uniform());
    }
    mean += first_order_index(x, y) / repeats;
  }
  EXPECT_NEAR(mean, 0, 0.02) << "eight classes by themselves explain a ninth of the variance";
}

TEST(Sensitivity, IsUnknownWhereNothingCanBeTold) {
  EXPECT_TRUE(std::isnan(first_order_index({1, 2, 3, 4, 5, 6}, {2, 2, 2, 2, 2, 2})));
  EXPECT_TRUE(std::isnan(first_order_index({1, 1, 1, 1}, {1, 2, 3, 4})));
}

TEST(Sensitivity, SignificanceIsThatOfStudent) {
  // r = 0.632 is what 10 pairs without dependence exceed in 5 of 100 cases, by any table of r.
  EXPECT_NEAR(significance_of(0.632, 10), 0.05, 0.0005);
  EXPECT_NEAR(significance_of(-0.632, 10), 0.05, 0.0005);
  EXPECT_EQ(significance_of(1, 10), 0);
  EXPECT_TRUE(std::isnan(significance_of(0.5, 3)));
  EXPECT_TRUE(std::isnan(significance_of(std::nan(""), 30)));
}

TEST(SizeEffect, FindsTheLawAgain) {
  std::vector<double> sizes, strengths;
  for (const double size : {0.05, 0.1, 0.2, 0.4}) {
    sizes.push_back(size);
    strengths.push_back(4e6 / std::sqrt(1 + size / 0.15));
  }
  const SizeEffect fit = fit_size_effect(sizes, strengths);
  EXPECT_NEAR(fit.plastic, 4e6, 1e2);
  EXPECT_NEAR(fit.transition, 0.15, 1e-5);
  EXPECT_NEAR(fit.determination, 1, 1e-9);
  EXPECT_FALSE(fit.bounded);
  EXPECT_NEAR(fit.strength(0.2), strengths[2], 1e2);
}

TEST(SizeEffect, SaysWhenThereIsNone) {
  const SizeEffect fit =
      fit_size_effect({0.1, 0.2, 0.4, 0.1, 0.2, 0.4}, {3e6, 3.1e6, 3.2e6, 3.2e6, 3e6, 3.3e6});
  EXPECT_TRUE(fit.bounded);
  EXPECT_LT(fit.determination, 0.5);
}

}  // namespace influences_test
