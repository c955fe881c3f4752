#include "libmpm/material/strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/libmpm/sample_scenes.hpp"

namespace strength_field_test {

constexpr double length = 2e-3;

double at(double x, double y, std::uint64_t seed = 1) { return mpm::field_random(seed, x, y, length); }

// Places five lengths apart are independent: their numbers must be uniform.
TEST(FieldRandom, IsUniformAtEveryPlaceOfItsLattice) {
  for (const double shift : {0.0, 0.13, 0.5}) {
    std::vector<double> r;
    for (int i = 0; i < 70; ++i)
      for (int k = 0; k < 70; ++k) r.push_back(at((5 * i + shift) * length, (5 * k + 0.7 * shift) * length));
    std::sort(r.begin(), r.end());
    double largest = 0;
    const auto n = static_cast<double>(r.size());
    for (std::size_t i = 0; i < r.size(); ++i)
      largest = std::max(largest, std::abs(r[i] - (static_cast<double>(i) + 0.5) / n));
    EXPECT_LT(largest, 1.63 / std::sqrt(n)) << "Kolmogorov and Smirnov, 1 %";
  }
}

double correlation(double distance) {
  double sum = 0;
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double x = 0.37 * i * length;
    const double y = 1.91 * i * length;
    sum += (at(x, y) - 0.5) * (at(x + distance, y) - 0.5);
  }
  return 12 * sum / n;
}

TEST(FieldRandom, IsAlikeNearbyAndIndependentFarAway) {
  EXPECT_GT(correlation(0.1 * length), 0.95);
  EXPECT_NEAR(correlation(length), 0.4, 0.15);
  EXPECT_NEAR(correlation(4 * length), 0, 0.05);
  EXPECT_NE(at(1e-3, 1e-3, 1), at(1e-3, 1e-3, 2));
}

/// Factors of the pixels of a specimen of 8 mm.
mpm::Scene picture(int pixels) {
  mpm::Scene scene = samples::mortar_block(pixels, pixels, 8e-3 / pixels);
  scene.damage.correlation_length = length;
  return scene;
}

TEST(StrengthFactors, OfAFinerPictureSampleTheSameField) {
  const mpm::Scene coarse = picture(12);
  const mpm::Scene fine = picture(36);
  const mpm::StrengthFactors of_coarse(coarse, false);
  const mpm::StrengthFactors of_fine(fine, true);
  for (int row = 0; row < 12; ++row)
    for (int col = 0; col < 12; ++col)
      EXPECT_NEAR(of_coarse.of_pixel(row, col), of_fine.of_pixel(3 * row + 1, 3 * col + 1), 1e-12);
}

TEST(StrengthFactors, AreTheSameKeptOrNot) {
  mpm::Scene scene = samples::small_concrete(20, 20);
  scene.extra_points = {{1e-3, 2e-3, samples::itz}, {1e-3, 2e-3, samples::aggregate}};
  const mpm::StrengthFactors drawn(scene, false);
  const mpm::StrengthFactors kept(scene, true);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(drawn.of_pixel(i, 19 - i), kept.of_pixel(i, 19 - i));
  EXPECT_EQ(drawn.of_pixel(0, 5), mpm::strength_factor(mpm::pixel_random(1, 0, 5), 1.5));
  EXPECT_EQ(drawn.of_extra_point(0), mpm::strength_factor(mpm::uniform_random(1, 0, 1), 1.5));
  EXPECT_EQ(drawn.of_extra_point(1), 1) << "aggregates do not fail";
}

TEST(StrengthFactors, OfAnExtraPointAreThoseOfItsPlaceInAField) {
  mpm::Scene scene = picture(8);
  scene.extra_points = {{2.5e-3, 1.5e-3, samples::mortar}};
  const mpm::StrengthFactors factors(scene, false);
  EXPECT_NEAR(factors.of_extra_point(0), factors.of_pixel(6, 2), 1e-12);
}

}  // namespace strength_field_test
