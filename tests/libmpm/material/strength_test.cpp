#include "libmpm/material/strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/libmpm/sample_scenes.hpp"

namespace strength_test {

using mpm::Phase;
using mpm::PrincipalStress;

Phase mortar() { return mpm::concrete_phases()[1]; }

// Known answers of Philox4x32-10 with counter and key zero (Salmon et al., kat_vectors): 6627e8d5 e169c58d
// ...
TEST(UniformRandom, IsPhilox) {
  const auto bits = (std::uint64_t{0x6627e8d5} << 32U) | 0xe169c58dU;
  EXPECT_EQ(mpm::uniform_random(0, 0, 0), (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52);
}

TEST(UniformRandom, DependsOnSeedPointAndStreamOnly) {
  EXPECT_EQ(mpm::uniform_random(7, 42, 0), mpm::uniform_random(7, 42, 0));
  EXPECT_NE(mpm::uniform_random(7, 42, 0), mpm::uniform_random(8, 42, 0));
  EXPECT_NE(mpm::uniform_random(7, 42, 0), mpm::uniform_random(7, 43, 0));
  EXPECT_NE(mpm::uniform_random(7, 42, 0), mpm::uniform_random(7, 42, 1));
  EXPECT_NE(mpm::pixel_random(1, 2, 3), mpm::pixel_random(1, 3, 2));
}

// Kolmogorov-Smirnov distance of n uniform numbers stays below 1.95 / sqrt(n) with a chance of 99.9 %; seeds
// are fixed.
TEST(StrengthFactor, FollowsTheWeibullDistribution) {
  constexpr int n = 20000;
  for (const double m : {1.0, 1.5, 6.0}) {
    std::vector<double> q;
    for (int i = 0; i < n; ++i) q.push_back(mpm::strength_factor(mpm::pixel_random(3, i, 11), m));
    std::sort(q.begin(), q.end());
    double distance = 0;
    for (int i = 0; i < n; ++i) {
      const double expected = 1 - std::exp(-std::pow(q[static_cast<std::size_t>(i)], m));
      distance = std::max(distance, std::abs(expected - (i + 0.5) / n));
    }
    EXPECT_LT(distance, 1.95 / std::sqrt(n)) << "m = " << m;
  }
}

TEST(StrengthFactor, IsOneAtTheScale) {
  // r = 1/e is survived by 36.8 %: the Weibull scale itself, whatever the modulus.
  for (const double m : {0.1, 1.5, 100.0})
    EXPECT_NEAR(mpm::strength_factor(1 / std::numbers::e, m), 1, 1e-12);
}

TEST(PrincipalStress, OfPureShear) {
  const auto s = mpm::principal_stress(0, 0, 3, 0);
  EXPECT_DOUBLE_EQ(s.first, 3);
  EXPECT_DOUBLE_EQ(s.second, -3);
}

TEST(Tension, FailsAboveTheThresholdOnly) {
  const Phase phase = mortar();
  EXPECT_FALSE(mpm::fails_in_tension(phase, 0.5, {7.49e6, 0, 0}));
  EXPECT_TRUE(mpm::fails_in_tension(phase, 0.5, {7.51e6, 0, 0}));
  EXPECT_TRUE(mpm::fails_in_tension(phase, 0.5, {0, -1e6, 7.51e6})) << "the stress out of the plane counts";
  EXPECT_FALSE(mpm::fails_in_tension(mpm::concrete_phases()[0], 0.5, {1e12, 0, 0}))
      << "aggregates are elastic";
}

TEST(Shear, FollowsMohrCoulomb) {
  const Phase phase = mortar();
  const double phi = phase.friction_angle;
  // Uniaxial compression: strength 2 c cos(phi) / (1 - sin(phi)) times q.
  const double strength = 2 * phase.cohesion * std::cos(phi) / (1 - std::sin(phi));
  EXPECT_FALSE(mpm::fails_in_shear(phase, 0.3, {0, -0.3 * strength * 0.999, 0}));
  EXPECT_TRUE(mpm::fails_in_shear(phase, 0.3, {0, -0.3 * strength * 1.001, 0}));
}

TEST(Shear, IsHeldBackByConfinementAndHelpedByTension) {
  const Phase phase = mortar();
  const double sine = std::sin(phase.friction_angle);
  const double cosine = std::cos(phase.friction_angle);
  for (const double s1 : {-40e6, 5e6}) {
    // -s3 (1 - sin) = q (2 c cos - s1 (1 + sin)), whichever of the three stresses is the least.
    const double s3 = -0.3 * (2 * 150e6 * cosine - s1 * (1 + sine)) / (1 - sine);
    EXPECT_FALSE(mpm::fails_in_shear(phase, 0.3, {s1, s3 * 0.999, s1}));
    EXPECT_TRUE(mpm::fails_in_shear(phase, 0.3, {s1, s3 * 1.001, s1}));
    EXPECT_FALSE(mpm::fails_in_shear(phase, 0.3, {s1, s1, s3 * 0.999}));
    EXPECT_TRUE(mpm::fails_in_shear(phase, 0.3, {s1, s1, s3 * 1.001}));
  }
}

TEST(Shear, NeedsCompressionAndFailsWhereTheBracketIsGone) {
  const Phase phase = mortar();
  EXPECT_FALSE(mpm::fails_in_shear(phase, 1, {1e12, 0, 0})) << "s3 = 0 is no shear failure";
  EXPECT_TRUE(mpm::fails_in_shear(phase, 1, {1e12, -1, 0})) << "bracket below zero: the point fails";
}

// The fast test rests on this: below the onset no shear failure is possible while s1 stays below the
// threshold.
TEST(ShearOnset, NeverMissesAFailure) {
  const Phase phase = mortar();
  for (const double factor : {0.01, 0.3, 1.0, 3.0, 8.0}) {
    const double tension = mpm::tension_threshold(phase, factor);
    const double onset = mpm::shear_onset(phase, factor, tension);
    for (int i = 0; i <= 100; ++i) {
      const double s1 = tension * (-20 + 0.21 * i);
      if (s1 > tension) continue;
      const PrincipalStress below{s1, std::min(-onset * 0.999999, 0.0), s1};
      EXPECT_FALSE(mpm::fails_in_shear(phase, factor, below)) << "q = " << factor << ", s1 = " << s1;
    }
    const PrincipalStress beyond{tension, -onset * 1.000001 - 1, tension};
    EXPECT_TRUE(mpm::fails_in_shear(phase, factor, beyond)) << "an onset too low costs time";
  }
}

TEST(ShearOnset, FallsWithTheCohesion) {
  const Phase phase = mortar();
  EXPECT_LT(mpm::shear_onset(phase, 1, 0, 0.25), 0.2501 * mpm::shear_onset(phase, 1, 0));
  EXPECT_EQ(mpm::shear_onset(phase, 1, mpm::tension_threshold(phase, 1), 0), 0);
}

TEST(ShearUtilisation, IsOneWhereThePointFails) {
  const Phase phase = mortar();
  for (const double factor : {0.3, 1.0, 4.0}) {
    for (const double s1 : {-2e6, 0.0, 5e6}) {
      const PrincipalStress unit{s1, -100e6, s1};
      const double share = mpm::shear_utilisation(phase, factor, unit);
      ASSERT_GT(share, 0);
      const auto scaled = [&](double by) { return PrincipalStress{by * s1, -by * 100e6, by * s1}; };
      EXPECT_TRUE(mpm::fails_in_shear(phase, factor, scaled(1.0001 / share)));
      EXPECT_FALSE(mpm::fails_in_shear(phase, factor, scaled(0.9999 / share)));
    }
  }
  EXPECT_EQ(mpm::shear_utilisation(phase, 1, {5e6, 1e6, 1e6}), 0) << "there is no compression";
}

TEST(CompressiveStrength, IsThatOfABarFreeSideways) {
  const Phase phase = mortar();
  EXPECT_NEAR(mpm::shear_utilisation(phase, 2, {0, -mpm::compressive_strength(phase, 2), 0}), 1, 1e-12);
}

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

}  // namespace strength_test
