#include "specimen/describe/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "specimen/body/raster.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {
namespace statistics_test {

constexpr double pi = std::numbers::pi, mm = 1e-3;

LabelledMask noise(int rows, int cols, double share) {
  LabelledMask mask{{rows, cols, phase::mortar}, 1, standard_phases()};
  Random random(1);
  for (std::uint8_t& label : mask.labels.data)
    label = random.uniform() < share ? phase::aggregate : phase::mortar;
  return mask;
}

LabelledMask packed() {
  const PackingOptions options;
  return draw_ellipses(pack(options).ellipses, options.width, options.height, 0.5 * mm).mask;
}

TEST(Statistics, FractionsAddUpToOne) {
  const LabelledMask mask = noise(50, 70, 0.3);
  const std::vector<double> shares = fractions(mask);
  ASSERT_EQ(shares.size(), 4u);
  EXPECT_NEAR(shares[phase::aggregate], 0.3, 0.03);
  EXPECT_DOUBLE_EQ(shares[phase::aggregate] + shares[phase::mortar], 1);
  EXPECT_EQ(shares[phase::itz], 0);
  EXPECT_EQ(fractions({{}, 1, standard_phases()})[phase::mortar], 0);
}

TEST(SieveCurve, OfAPackingFollowsItsGrading) {
  const PackingOptions options;
  std::vector<Inclusion> inclusions;
  for (const Ellipse& e : pack(options).ellipses) inclusions.push_back(make_inclusion(1, e));
  const std::vector<Passing> curve = sieve_curve(inclusions, options.grading);
  ASSERT_EQ(curve.size(), options.grading.size() + 1);
  EXPECT_DOUBLE_EQ(curve.front().diameter, 5 * mm);
  EXPECT_DOUBLE_EQ(curve.back().diameter, 20 * mm);
  EXPECT_EQ(curve.front().target, 0);
  EXPECT_NEAR(curve.back().target, 1, 1e-14);
  EXPECT_NEAR(curve.back().reached, 1, 1e-14);
  for (const Passing& point : curve) EXPECT_NEAR(point.reached, point.target, 0.025) << point.diameter;
}

TEST(SieveCurve, WithoutAGradingHasTenSizes) {
  std::vector<Inclusion> inclusions;
  for (const double a : {1.0, 2.0, 5.5}) inclusions.push_back(make_inclusion(1, {0, 0, a, a, 0}));
  const std::vector<Passing> curve = sieve_curve(inclusions, {});
  ASSERT_EQ(curve.size(), 10u);
  EXPECT_DOUBLE_EQ(curve[0].diameter, 2);
  EXPECT_DOUBLE_EQ(curve[9].diameter, 11);
  EXPECT_NEAR(curve[0].reached, 1 / 35.25, 1e-12);
  EXPECT_NEAR(curve[2].reached, 5 / 35.25, 1e-12);  // 4 mm
  EXPECT_DOUBLE_EQ(curve[9].reached, 1);
  EXPECT_TRUE(std::isnan(curve[5].target));
  EXPECT_TRUE(sieve_curve({}, {}).empty());
  EXPECT_EQ(sieve_curve({}, named_grading("fuller", 5 * mm, 20 * mm)).back().reached, 0);
}

TEST(TwoPoint, IsTheCountOfPairs) {
  const LabelledMask mask = noise(130, 200, 0.4);
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  ASSERT_EQ(s2.radial.size(), 66u);
  const auto share = [&](int down, int right) {
    double pairs = 0;
    for (int row = 0; row + down < 130; ++row) {
      for (int col = 0; col + right < 200; ++col)
        pairs += mask.labels(row, col) == phase::aggregate &&
                 mask.labels(row + down, col + right) == phase::aggregate;
    }
    return pairs / ((130 - down) * (200 - right));
  };
  for (const int lag : {0, 1, 13, 63, 64, 65}) {
    EXPECT_NEAR(s2.along_x[lag], share(0, lag), 1e-15) << lag;
    EXPECT_NEAR(s2.along_y[lag], share(lag, 0), 1e-15) << lag;
    EXPECT_EQ(s2.distance[lag], lag);
  }
}

// Lengths that round to 1 are those of (0, 1), (1, 0), (1, 1) and (1, -1).
TEST(TwoPoint, IsRadiallyTheMeanOfAllShiftsOfALength) {
  LabelledMask mask{{4, 5, phase::mortar}, 1, standard_phases()};
  for (const auto& [row, col] : {std::pair{1, 1}, {1, 2}, {2, 2}, {0, 3}}) mask.labels(row, col) = 1;
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  ASSERT_EQ(s2.radial.size(), 3u);
  EXPECT_DOUBLE_EQ(s2.radial[0], 4.0 / 20);
  EXPECT_DOUBLE_EQ(s2.radial[1], (1.0 + 1 + 1 + 1) / (4 * 4 + 3 * 5 + 3 * 4 + 3 * 4));
}

TEST(TwoPoint, OfIndependentPixelsIsTheSquareOfTheFraction) {
  const TwoPoint s2 = two_point_correlation(noise(400, 400, 0.3), phase::aggregate);
  EXPECT_NEAR(s2.radial[0], 0.3, 0.005);
  for (std::size_t lag = 1; lag < s2.radial.size(); ++lag) {
    EXPECT_NEAR(s2.radial[lag], 0.09, 0.002) << lag;
    EXPECT_NEAR(s2.along_x[lag], 0.09, 0.006) << lag;
    EXPECT_NEAR(s2.along_y[lag], 0.09, 0.006) << lag;
  }
}

TEST(TwoPoint, OfACheckerboardAlternates) {
  LabelledMask mask{{60, 80, phase::mortar}, 1, standard_phases()};
  for (int row = 0; row < 60; ++row)
    for (int col = 0; col < 80; ++col) mask.labels(row, col) = (row + col) % 2 == 0 ? 1 : 2;
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  for (std::size_t lag = 0; lag < s2.distance.size(); ++lag) {
    EXPECT_DOUBLE_EQ(s2.along_x[lag], lag % 2 == 0 ? 0.5 : 0);
    EXPECT_DOUBLE_EQ(s2.along_y[lag], lag % 2 == 0 ? 0.5 : 0);
  }
}

// Discs of radius R at independent places, n of them per area: a point is in none of them with probability
// exp(-n pi R^2), two points with exp(-n U(r)), where U is the area of two discs together.
TEST(TwoPoint, OfABooleanModelIsTheClosedForm) {
  constexpr double radius = 8, density = 0.7 / (pi * radius * radius);
  constexpr int side = 1000;
  LabelledMask mask{{side, side, phase::mortar}, 1, standard_phases()};
  Random random(3);
  const double wide = side + 2 * radius;
  for (int disc = 0; disc < std::lround(density * wide * wide); ++disc) {
    const double x = random.uniform(-radius, side + radius), y = random.uniform(-radius, side + radius);
    for (int row = std::max(0, static_cast<int>(y - radius)); row < std::min(side + 0.0, y + radius); ++row)
      for (int col = std::max(0, static_cast<int>(x - radius)); col < std::min(side + 0.0, x + radius); ++col)
        if (std::hypot(row + 0.5 - y, col + 0.5 - x) <= radius) mask.labels(row, col) = phase::aggregate;
  }
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  const double outside = std::exp(-0.7);
  for (const int lag : {0, 2, 4, 6, 8, 10, 12, 14, 16, 20, 30}) {
    const double r = std::min(lag + 0.0, 2 * radius);
    const double both =
        2 * radius * radius * std::acos(r / (2 * radius)) - r / 2 * std::sqrt(4 * radius * radius - r * r);
    const double expected = 1 - 2 * outside + std::exp(-density * (2 * pi * radius * radius - both));
    EXPECT_NEAR(s2.radial[lag], expected, 0.012) << lag;  // the sampling error of the fraction is 0.008
  }
}

TEST(TwoPoint, GoesFromTheFractionToItsSquare) {
  const LabelledMask mask = packed();
  const double share = fractions(mask)[phase::aggregate];
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  EXPECT_DOUBLE_EQ(s2.radial.front(), share);
  EXPECT_NEAR(s2.distance.back(), 0.075, 1e-12);
  double far = 0;
  for (std::size_t lag = 100; lag < 150; ++lag) far += s2.radial[lag] / 50;
  EXPECT_NEAR(far, share * share, 0.02);
}

// Debye: the slope of S2 at nought is -perimeter / (pi area of the specimen). No aggregate reaches the walls,
// so the pairs that do not fit between them at a lag are all of mortar: that adds fraction / width.
TEST(TwoPoint, FallsWithThePerimeter) {
  const PackingOptions options;
  const std::vector<Ellipse> ellipses = pack(options).ellipses;
  const LabelledMask mask = draw_ellipses(ellipses, options.width, options.height, 0.25 * mm).mask;
  double boundary = 0;
  for (const Ellipse& e : ellipses) boundary += perimeter(e);
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  const auto fall = [&](const std::vector<double>& s) { return (s[2] - s[0]) / s2.distance[2]; };
  const double slope = (fall(s2.along_x) + fall(s2.along_y)) / 2;  // up to the gap of 0.5 mm
  const double expected = -boundary / (pi * 0.15 * 0.15) + 0.45 / 0.15;
  EXPECT_NEAR(slope / expected, 1, 0.03);
}

TEST(TwoPoint, OfStripesIsPeriodicAcrossAndConstantAlong) {
  LabelledMask mask{{64, 64, phase::mortar}, 1, standard_phases()};
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col)
      mask.labels(row, col) = row / 4 % 2 == 0 ? phase::aggregate : phase::mortar;
  }
  const TwoPoint s2 = two_point_correlation(mask, phase::aggregate);
  EXPECT_DOUBLE_EQ(s2.along_x[4], 0.5);
  EXPECT_DOUBLE_EQ(s2.along_y[4], 0);
  EXPECT_DOUBLE_EQ(s2.along_y[8], 0.5);
}

TEST(Perimeter, OfADiscIsRightToTwoPerCent) {
  for (const double diameter : {20.0, 50.0, 80.0}) {
    const Ellipse disc{0.0503, 0.0501, diameter / 2 * mm, diameter / 2 * mm, 0};
    const LabelledMask mask = draw_ellipses({disc}, 0.1, 0.1, 0.5 * mm).mask;
    EXPECT_NEAR(perimeter(mask, phase::aggregate) / (pi * diameter * mm), 1, 0.02) << diameter;
    EXPECT_DOUBLE_EQ(perimeter(mask, phase::aggregate), perimeter(mask, phase::mortar));
  }
}

TEST(Perimeter, OfAPackingIsThatOfItsEllipses) {
  const PackingOptions options;
  const std::vector<Ellipse> ellipses = pack(options).ellipses;
  double boundary = 0;
  for (const Ellipse& e : ellipses) boundary += perimeter(e);
  const LabelledMask mask = draw_ellipses(ellipses, options.width, options.height, 0.25 * mm).mask;
  EXPECT_NEAR(perimeter(mask, phase::aggregate) / boundary, 1, 0.02);
}

// Four directions cannot do better on a square: pi / 8 (4 + 4 sqrt 2) = 3.79 instead of 4 edges.
TEST(Perimeter, OfASquareIsTheMeanOfFourDirections) {
  LabelledMask mask{{100, 100, phase::mortar}, 0.01, standard_phases()};
  for (int row = 20; row < 80; ++row) {
    for (int col = 20; col < 80; ++col) mask.labels(row, col) = phase::aggregate;
  }
  EXPECT_NEAR(perimeter(mask, phase::aggregate), pi / 8 * (4 + 4 * std::numbers::sqrt2) * 0.6, 0.02);
  EXPECT_EQ(perimeter(mask, phase::itz), 0);
}

}  // namespace statistics_test
}  // namespace specimen
