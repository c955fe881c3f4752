#include "apps/statistics/weibull_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/strength.hpp"
#include "specimen/body/raster.hpp"

namespace weibull_fit_test {

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

/// A sample of a Weibull distribution.
std::vector<double> sample(specimen::Random& random, int count, double scale, double modulus) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(scale * std::pow(-std::log1p(-random.uniform()), 1 / modulus));
  return values;
}

TEST(WeibullFit, IsThatOfMaximumLikelihood) {
  specimen::Random random(5);
  const WeibullFit fit = fit_weibull(sample(random, 20'000, 3.5e6, 12));
  EXPECT_NEAR(fit.scale, 3.5e6, 3 * 3.5e6 * fit.log_error(1 - std::exp(-1)));
  EXPECT_NEAR(fit.modulus, 12, 3 * 12 * fit.modulus_error());
  EXPECT_NEAR(fit.quantile(1 - std::exp(-1)), fit.scale, 1e-3);
  // Three values by hand: the modulus makes 1 / m + mean(ln x) = sum(x^m ln x) / sum(x^m).
  const WeibullFit three = fit_weibull({1, 2, 4});
  double powers = 0, weighted = 0;
  for (const double x : {1.0, 2.0, 4.0}) {
    powers += std::pow(x, three.modulus);
    weighted += std::pow(x, three.modulus) * std::log(x);
  }
  EXPECT_NEAR(1 / three.modulus + std::log(2), weighted / powers, 1e-9);
  EXPECT_NEAR(std::pow(three.scale, three.modulus), powers / 3, 1e-9);
}

TEST(WeibullFit, NeedsValuesThatDiffer) {
  EXPECT_TRUE(std::isnan(fit_weibull({2, 2, 2}).modulus));
  EXPECT_TRUE(std::isnan(fit_weibull({}).scale));
}

TEST(WeibullFit, ErrorsAreThoseOfRepeatedSamples) {
  constexpr int samples = 2000, count = 100;
  constexpr double scale = 3, modulus = 10;
  specimen::Random random(11);
  for (const double p : {0.05, 0.5, 0.95}) {
    const double exact = std::log(scale * std::pow(-std::log1p(-p), 1 / modulus));
    double squares = 0, error = 0;
    int inside = 0;
    for (int i = 0; i < samples; ++i) {
      const WeibullFit fit = fit_weibull(sample(random, count, scale, modulus));
      const double distance = std::log(fit.quantile(p)) - exact;
      squares += distance * distance / samples;
      error += fit.log_error(p) / samples;
      inside += std::abs(distance) < 1.96 * fit.log_error(p) ? 1 : 0;
    }
    EXPECT_NEAR(error / std::sqrt(squares), 1, 0.06) << p;
    EXPECT_NEAR(static_cast<double>(inside) / samples, 0.95, 0.02) << p;
  }
}

}  // namespace weibull_fit_test
