#include "apps/weibull_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/strength.hpp"

namespace {

using namespace app;
using testing::DoubleNear;
using testing::ElementsAre;

double uniform(double x) { return x; }

TEST(WeibullFit, ScaleIsWhere632PercentAreWeaker) {
  EXPECT_NEAR(weibull_distribution(9, 9, 1.5), 1 - std::exp(-1), 1e-12);
  EXPECT_NEAR(weibull_distribution(9, 9, 6), 1 - std::exp(-1), 1e-12);
}

TEST(WeibullFit, DensityIsTheSlopeOfTheDistribution) {
  for (const double x : {2.0, 9.0, 20.0}) {
    const double slope =
        (weibull_distribution(x + 1e-4, 9, 1.5) - weibull_distribution(x - 1e-4, 9, 1.5)) / 2e-4;
    EXPECT_NEAR(weibull_density(x, 9, 1.5), slope, 1e-8);
  }
}

TEST(WeibullFit, DistanceOfAFewValuesByHand) {
  EXPECT_DOUBLE_EQ(largest_distance({0.75, 0.25}, uniform), 0.25);
  EXPECT_DOUBLE_EQ(largest_distance({0.5, 0.6}, uniform), 0.5);  // none of them below 0.5
  EXPECT_DOUBLE_EQ(largest_distance({0.1, 0.2}, uniform), 0.8);  // both below 0.2
}

TEST(WeibullFit, CriticalDistanceFallsWithTheRootOfTheCount) {
  EXPECT_DOUBLE_EQ(critical_distance(10000), 0.01358);
}

TEST(WeibullFit, TellsAWeibullSampleFromAnother) {
  std::vector<double> sample;
  for (int i = 0; i < 5000; ++i) sample.push_back(9 * mpm::strength_factor(mpm::pixel_random(1, i, 0), 1.5));
  const auto fits = [&](double modulus) {
    return largest_distance(sample, [=](double x) { return weibull_distribution(x, 9, modulus); }) <=
           critical_distance(sample.size());
  };
  EXPECT_TRUE(fits(1.5));
  EXPECT_FALSE(fits(1.6));
}

TEST(WeibullFit, HistogramIsADensity) {
  EXPECT_THAT(histogram({0.5, 1.5, 1.6, 9}, 2, 2),
              ElementsAre(DoubleNear(0.25, 1e-12), DoubleNear(0.5, 1e-12)));
}

}  // namespace
