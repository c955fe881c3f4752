#include "specimen/pack/grading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "specimen/body/error.hpp"

namespace specimen {
namespace sizes_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr double mm = 1e-3;

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

}  // namespace sizes_test
}  // namespace specimen
