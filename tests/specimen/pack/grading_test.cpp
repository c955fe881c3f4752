#include "specimen/pack/grading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "specimen/body/error.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {
namespace grading_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr double mm = 1e-3;

double sum_of_shares(const Grading& grading) {
  double sum = 0;
  for (const SizeClass& size : grading) sum += size.share;
  return sum;
}

// Share below a class limit.
double passing(const Grading& grading, double d) {
  double sum = 0;
  for (const SizeClass& size : grading) sum += size.d_max <= d * (1 + 1e-9) ? size.share : 0;
  return sum;
}

std::string refusal(std::string_view name, double d_min, double d_max) {
  try {
    (void)named_grading(name, d_min, d_max);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Grading, ClassesFallAndMeetAndMakeUpTheWhole) {
  for (const std::string& name : grading_names()) {
    for (const bool walraven : {false, true}) {
      const Grading grading = named_grading(name, 0.7 * mm, 7.5 * mm, walraven);
      EXPECT_NEAR(sum_of_shares(grading), 1, 1e-14) << name;
      EXPECT_DOUBLE_EQ(grading.front().d_max, 7.5 * mm) << name;
      EXPECT_DOUBLE_EQ(grading.back().d_min, 0.7 * mm) << name;
      for (std::size_t i = 0; i < grading.size(); ++i) {
        EXPECT_GT(grading[i].d_max, grading[i].d_min) << name;
        EXPECT_GT(grading[i].share, 0) << name;
        if (i > 0) {
          EXPECT_EQ(grading[i].d_max, grading[i - 1].d_min) << name;
        }
      }
    }
  }
}

TEST(Grading, FullerIsTheRootAtTheStandardSieves) {
  const Grading fuller = named_grading("fuller", 5 * mm, 20 * mm);
  const std::vector<double> sieves{6.3, 8, 10, 12.5, 16, 20};
  ASSERT_EQ(fuller.size(), sieves.size());
  for (const double sieve : sieves) {
    const double expected = (std::sqrt(sieve) - std::sqrt(5.0)) / (std::sqrt(20.0) - std::sqrt(5.0));
    EXPECT_NEAR(passing(fuller, sieve * mm), expected, 1e-14) << sieve;
  }
}

// DIN 1045-2, A16: 21 % pass 2 mm, 36 % pass 4 mm, 60 % pass 8 mm.
TEST(Grading, DinCurveIsCutAndRenormalised) {
  const Grading a16 = named_grading("A16", 2 * mm, 16 * mm);
  ASSERT_EQ(a16.size(), 3u);
  EXPECT_NEAR(a16[0].share, (100 - 60) / 79.0, 1e-14);
  EXPECT_NEAR(a16[1].share, (60 - 36) / 79.0, 1e-14);
  EXPECT_NEAR(a16[2].share, (36 - 21) / 79.0, 1e-14);
  const Grading cut = named_grading("A16", 3 * mm, 12 * mm);  // 28.5 % and 80 % by straight lines
  ASSERT_EQ(cut.size(), 3u);
  EXPECT_NEAR(cut[0].share, (80 - 60) / 51.5, 1e-14);
  EXPECT_NEAR(cut[2].share, (36 - 28.5) / 51.5, 1e-14);
}

TEST(Grading, NothingIsLargerThanTheCurve) {
  EXPECT_EQ(named_grading("B8", 2 * mm, 20 * mm).front().d_max, 8 * mm);
  EXPECT_EQ(named_grading("C32", 2 * mm, 40 * mm).front().d_max, 31.5 * mm);
}

// Walraven (1980): area share below D0 in a plane cut through spheres that follow Fuller's curve.
TEST(Grading, PlaneCutOfFullerIsWalravensPolynomial) {
  const double d_max = 20, d_min = 2;
  const auto walraven = [&](double d) {
    const double x = d / d_max;
    return 1.065 * std::sqrt(x) - 0.053 * std::pow(x, 4) - 0.012 * std::pow(x, 6) - 0.0045 * std::pow(x, 8) +
           0.0025 * std::pow(x, 10);
  };
  const Grading cut = named_grading("fuller", d_min * mm, d_max * mm, true);
  for (const SizeClass& size : cut) {
    const double d = size.d_max / mm;
    const double expected = (walraven(d) - walraven(d_min)) / (walraven(d_max) - walraven(d_min));
    EXPECT_NEAR(passing(cut, size.d_max), expected, 1e-12) << d;
  }
}

// Spheres drawn by volume, cut at random heights, their circles weighed by area.
TEST(Grading, PlaneCutOfADinCurveIsThatOfRandomCuts) {
  const double d_min = 1 * mm, d_max = 16 * mm;
  const Grading volume = named_grading("A16", 0.25 * mm, d_max),
                cut = named_grading("A16", d_min, d_max, true);
  Random random(1);
  constexpr int count = 200'000;
  std::vector<double> area(cut.size(), 0);
  double whole = 0;
  for (const SizeClass& size : volume) {
    for (int n = 0; n < count * size.share; ++n) {
      const double sphere = random.uniform(size.d_min, size.d_max), height = random.uniform();
      const double circle = sphere * std::sqrt(1 - height * height), weight = 1 - height * height;
      for (std::size_t i = 0; i < cut.size(); ++i) {
        if (circle < cut[i].d_min || circle >= cut[i].d_max) continue;
        area[i] += weight;
        whole += weight;
      }
    }
  }
  for (std::size_t i = 0; i < cut.size(); ++i)
    EXPECT_NEAR(cut[i].share, area[i] / whole, 0.006) << cut[i].d_max;  // some five standard errors
}

TEST(Grading, PlaneCutShowsSmallerCircles) {
  const Grading volume = named_grading("A16", 1 * mm, 16 * mm),
                cut = named_grading("A16", 1 * mm, 16 * mm, true);
  for (const double sieve : {2.0, 4.0, 8.0}) EXPECT_GT(passing(cut, sieve * mm), passing(volume, sieve * mm));
}

TEST(Grading, UnknownNameIsAnsweredWithTheNearest) {
  EXPECT_EQ(refusal("fulller", 5 * mm, 20 * mm),
            "generate.grading: fulller; must be one of fuller, A8, B8, C8, A16, B16, C16, A32, B32, C32; "
            "did you mean \"fuller\"?");
  EXPECT_THAT(refusal("a16", 5 * mm, 10 * mm), testing::HasSubstr("did you mean \"A16\"?"));
}

TEST(Grading, EmptyRangeIsRefused) {
  EXPECT_EQ(refusal("fuller", 20 * mm, 5 * mm),
            "generate.d_max: 5 mm; must be above d_min, which is 20 mm; swap them or widen the range");
  EXPECT_EQ(refusal("fuller", 0, 5 * mm),
            "generate.d_min: 0 mm; must be > 0; give the size of the smallest aggregate");
  EXPECT_THAT(refusal("fuller", not_a_number, 5 * mm), testing::HasSubstr("generate.d_min: nan"));
  EXPECT_THAT(refusal("fuller", 5 * mm, infinite), testing::HasSubstr("generate.d_max: inf"));
  EXPECT_EQ(refusal("A8", 8 * mm, 20 * mm),
            "generate.d_min: 8 mm; must be below 8 mm, the largest aggregate of the curve A8; lower d_min or "
            "choose a coarser grading");
  EXPECT_EQ(refusal("A8", 0.1 * mm, 8 * mm),
            "generate.d_min: 0.1 mm; must be at least 0.25 mm, where the curve A8 begins; raise d_min or use "
            "the grading fuller");
}

double disc(double d) { return std::numbers::pi / 4 * d * d; }

double total(const std::vector<double>& diameters) {
  double sum = 0;
  for (const double d : diameters) sum += disc(d);
  return sum;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Sizes, MakeUpTheAreaWithinTheirLimits) {
  for (const std::string& name : grading_names()) {
    for (const double area : {0.002, 0.01, 0.2}) {
      Random random(1);
      const Grading grading = named_grading(name, 2 * mm, 20 * mm);
      const std::vector<double> diameters = draw_sizes(grading, area, random);
      EXPECT_NEAR(total(diameters) / area, 1, 1e-13) << name;
      EXPECT_TRUE(std::is_sorted(diameters.rbegin(), diameters.rend())) << name;
      EXPECT_LE(diameters.front(), grading.front().d_max) << name;
      EXPECT_GE(diameters.back(), grading.back().d_min) << name;
    }
  }
}

TEST(Sizes, FollowTheCurveToHalfAnAggregate) {
  const double area = 0.45 * 0.15 * 0.15;
  const Grading grading = named_grading("fuller", 5 * mm, 20 * mm);
  for (int seed = 1; seed <= 50; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const std::vector<double> diameters = draw_sizes(grading, area, random);
    double due = 0;
    for (const SizeClass& size : grading) {
      due += size.share * area;
      double above = 0;
      for (const double d : diameters) above += d >= size.d_min ? disc(d) : 0;
      // Half an aggregate, and one that the common scaling may have taken across the limit.
      EXPECT_LE(std::abs(above - due), 1.51 * disc(size.d_max)) << seed;
    }
  }
}

// Area spread evenly over the diameter: half of it below the middle of the class.
TEST(Sizes, SpreadAreaEvenlyOverAClass) {
  Random random(2);
  const std::vector<double> diameters = draw_sizes({{5 * mm, 20 * mm, 1}}, 5, random);
  double below = 0;
  for (const double d : diameters) below += d < 12.5 * mm ? disc(d) : 0;
  EXPECT_NEAR(below / 5, 0.5, 0.01);
}

TEST(Sizes, ExpectedCountIsMet) {
  Random random(3);
  const Grading grading = named_grading("fuller", 5 * mm, 20 * mm);
  const double count = static_cast<double>(draw_sizes(grading, 1, random).size());
  EXPECT_NEAR(expected_count(grading, 1) / count, 1, 0.02);
}

TEST(Sizes, OneSizeIsScaledByAHair) {
  Random random(4);
  const std::vector<double> diameters = draw_sizes({{10 * mm, 10 * mm, 1}}, 20.4 * disc(10 * mm), random);
  EXPECT_EQ(diameters.size(), 20u);
  EXPECT_NEAR(diameters.front(), 10 * mm * std::sqrt(1.02), 1e-15);
}

TEST(Sizes, AreaThatNoAggregateHasIsRefused) {
  Random random(5);
  EXPECT_EQ(refusal([&] {
              (void)draw_sizes({{5 * mm, 20 * mm, 1}}, 10e-6, random);
            }),
            "generate.fraction: 10 mm^2 of aggregate; must be at least one aggregate of 5 mm, 19.635 mm^2; "
            "raise the fraction or lower d_min");
  EXPECT_EQ(refusal([&] {
              (void)draw_sizes({{5 * mm, 5 * mm, 1}}, 30e-6, random);
            }),
            "generate.fraction: 30 mm^2 of aggregate; no whole number of aggregates of 5 mm to 5 mm has that "
            "area; widen the range of sizes or change the fraction");
}

TEST(Sizes, ImpossibleGradingIsRefused) {
  EXPECT_EQ(refusal([] { check({}); }),
            "generate.grading: no size class; must have at least one; add d_min, d_max and share");
  EXPECT_EQ(refusal([] {
              check({{5 * mm, 4 * mm, 1}});
            }),
            "generate.grading: 5 mm to 4 mm; a class must have 0 < d_min <= d_max");
  EXPECT_EQ(refusal([] {
              check({{5 * mm, 8 * mm, 0.5}, {4 * mm, 6 * mm, 0.5}});
            }),
            "generate.grading: 4 mm to 6 mm; classes must be in falling order and must not overlap");
  EXPECT_EQ(refusal([] {
              check({{5 * mm, 8 * mm, 0.5}, {4 * mm, 5 * mm, 0.4}});
            }),
            "generate.grading: shares that add up to 0.9; must add up to 1");
  EXPECT_THAT(refusal([] {
                check({{5 * mm, 8 * mm, 1.5}, {4 * mm, 5 * mm, -0.5}});
              }),
              testing::HasSubstr("share -0.5 of 4 mm to 5 mm; must be >= 0"));
  EXPECT_NE(refusal([] { check({{not_a_number, 8 * mm, 1}}); }), "");
  EXPECT_NE(refusal([] { check({{5 * mm, 8 * mm, not_a_number}}); }), "");
  EXPECT_EQ(refusal([] { check({{5 * mm, 8 * mm, 0.5}, {4 * mm, 5 * mm, 0.5}}); }), "");
}

}  // namespace grading_test
}  // namespace specimen
