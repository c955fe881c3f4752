#include "specimen/describe/misfit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace specimen {
namespace misfit_test {

Descriptors with(double fraction, double diameter, std::vector<double> s2, double pixel_size = 1) {
  Descriptors d;
  d.fraction = fraction;
  d.median_diameter = diameter;
  d.sample.aggregates = {{diameter, 0.5, 0, 1}};
  for (std::size_t lag = 0; lag < s2.size(); ++lag)
    d.s2.distance.push_back(static_cast<double>(lag) * pixel_size);
  d.s2.radial = d.s2.along_x = d.s2.along_y = std::move(s2);
  return d;
}

TEST(Misfit, OfAFigureTellsMeanScatterAndWhetherTheOriginalIsWithin) {
  const Misfit misfit =
      compare(with(0.5, 10, {0.5}), {with(0.4, 8, {0.4}), with(0.6, 9, {0.6}), with(0.5, 7, {0.5})});
  EXPECT_DOUBLE_EQ(misfit.fraction.mean, 0.5);
  EXPECT_NEAR(misfit.fraction.deviation, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(misfit.fraction.least, 0.4);
  EXPECT_DOUBLE_EQ(misfit.fraction.largest, 0.6);
  EXPECT_TRUE(misfit.fraction.within());
  EXPECT_DOUBLE_EQ(misfit.median_diameter.difference(), -2);
  EXPECT_FALSE(misfit.median_diameter.within());
}

TEST(Misfit, OfS2IsOverTheVarianceOfTheOriginal) {
  const Descriptors original = with(0.5, 10, {0.5, 0.3, 0.25});
  const std::vector<Descriptors> twins{with(0.5, 10, {0.5, 0.32, 0.25}), with(0.5, 10, {0.5, 0.34, 0.25})};
  const Misfit misfit = compare(original, twins);
  EXPECT_NEAR(misfit.s2_largest.original, 0.03 / 0.25, 1e-12);
  EXPECT_NEAR(misfit.s2_rms.original, 0.03 / 0.25 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(misfit.s2_largest.largest, 0.02 / 0.25, 1e-12);  // each from the other one
  EXPECT_NEAR(misfit.s2_largest.mean, 0.02 / 0.25, 1e-12);
  EXPECT_FALSE(misfit.s2_largest.within());
  EXPECT_TRUE(compare(with(0.5, 10, {0.5, 0.33, 0.25}), twins).s2_rms.within());
}

TEST(Misfit, OfSizesIsTheDistanceOfTheirCurves) {
  const Misfit misfit = compare(with(0.5, 10, {0.5}), {with(0.5, 8, {0.5}), with(0.5, 10, {0.5})});
  EXPECT_DOUBLE_EQ(misfit.sizes.original, 0.5);
  EXPECT_DOUBLE_EQ(misfit.sizes_mean.original, 1);
  EXPECT_DOUBLE_EQ(misfit.sizes.largest, 1);
  EXPECT_DOUBLE_EQ(misfit.sizes_mean.largest, 2);
}

TEST(Misfit, OfNeighboursIsTheDistanceOfTheirDistributions) {
  Descriptors original = with(0.5, 10, {0.5});
  std::vector<Descriptors> twins{original, original, original};
  original.gaps = {0, 0, 2, 3};
  twins[0].gaps = {1, 2, 3, 4};
  twins[1].gaps = {1, 2, 3, 4};
  twins[2].gaps = {1, 2, 4, 4};
  const Misfit misfit = compare(original, twins);
  EXPECT_DOUBLE_EQ(misfit.gaps.original, 0.5);
  EXPECT_DOUBLE_EQ(misfit.gaps.largest, 0.25);
  EXPECT_FALSE(misfit.gaps.within());
}

TEST(Misfit, OfASingleTwinHasNoScatterAndNoVerdict) {
  const Misfit misfit = compare(with(0.5, 10, {0.5}), {with(0.4, 10, {0.4})});
  EXPECT_TRUE(std::isnan(misfit.fraction.deviation));
  EXPECT_TRUE(std::isnan(misfit.s2_rms.largest));
  EXPECT_FALSE(misfit.s2_rms.within());
}

TEST(Misfit, ComparesS2OfOtherPixelsAndSizesWhereBothHaveIt) {
  EXPECT_NEAR(
      compare(with(0.5, 10, {0.5, 0.4, 0.3, 0.2}), {with(0.5, 10, {0.5, 0.3}, 2)}).s2_largest.original, 0,
      1e-12);
  const Descriptors wide = with(0.5, 10, std::vector<double>(1000, 0.3)),
                    narrow = with(0.5, 10, {0.3, 0.3, 0.2});
  EXPECT_NEAR(compare(wide, {narrow}).s2_rms.original, 0.1 / 0.25 / std::sqrt(3), 1e-12);
  const std::vector<double> values = at_distances({0, 2, 4}, {1, 3, 1}, {0, 1, 2, 3.5, 4, 5});
  ASSERT_EQ(values.size(), 5u);
  EXPECT_DOUBLE_EQ(values[1], 2);
  EXPECT_DOUBLE_EQ(values[2], 3);
  EXPECT_DOUBLE_EQ(values[3], 1.5);
  EXPECT_DOUBLE_EQ(values[4], 1);
}

TEST(Misfit, TellsTheMeanDirectionAcrossTheZero) {
  std::vector<Descriptors> twins{with(0.5, 10, {0.5}), with(0.5, 10, {0.5})};
  twins[0].orientation = {0.1, 0.5, 0};
  twins[1].orientation = {3.14159265 - 0.1, 0.5, 0};
  const double direction = compare(with(0.5, 10, {0.5}), twins).direction;
  EXPECT_NEAR(std::sin(direction), 0, 1e-6);
}

}  // namespace misfit_test
}  // namespace specimen
