#include "specimen/body/ellipse_gap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {
namespace ellipse_gap_test {

Body random_body(Random& random, double aspect_min) {
  const double d = random.uniform(5, 20), root = std::sqrt(random.uniform(aspect_min, 1));
  return body_of({0, 0, d / 2 / root, d / 2 * root, random.uniform(0, std::numbers::pi)});
}

Point direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(Strip, SlopeAndCurvatureAreItsDerivatives) {
  Random random(1);
  for (int n = 0; n < 200; ++n) {
    const Body first = random_body(random, 0.1);
    Body second = random_body(random, 0.1);
    second.centre = {random.uniform(-30, 30), random.uniform(-30, 30)};
    const double angle = random.uniform(0, 6), step = 1e-5;
    const auto at = [&](double t) { return strip_between(first, second, direction(t)); };
    EXPECT_NEAR(at(angle).slope, (at(angle + step).width - at(angle - step).width) / (2 * step), 1e-6);
    EXPECT_NEAR(at(angle).curvature, -(at(angle + step).slope - at(angle - step).slope) / (2 * step), 1e-6);
  }
}

TEST(Strip, SupportPointIsTheFarthestOfTheBoundary) {
  const Body body = body_of({0, 0, 3, 1, 0.5});
  const Point u = direction(1.1);
  const double farthest = dot(support_point(body, u), u);
  for (int i = 0; i < 1000; ++i) {
    const double t = 2 * std::numbers::pi * i / 1000;
    const Point axis = direction(0.5), p = (3 * std::cos(t)) * axis + std::sin(t) * turned_left(axis);
    EXPECT_LE(dot(p, u), farthest + 1e-15);
  }
}

// Pairs as placement meets them: the second centre anywhere in the box that could touch the first.
TEST(GapTest, NeedsFewEvaluations) {
  for (const auto& [aspect, most] : {std::pair{0.5, 2.4}, {0.02, 3.0}}) {
    Random random(2);
    long evaluations = 0, asked = 0;
    int worst = 0;
    for (int n = 0; n < 100'000; ++n) {
      const Body first = random_body(random, aspect);
      Body second = random_body(random, aspect);
      const double reach = first.a + second.a + 0.5;
      second.centre = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
      const GapAnswer answer = test_gap(first, second, 0.5);
      evaluations += answer.evaluations;
      asked += answer.evaluations > 0;
      worst = std::max(worst, answer.evaluations);
    }
    EXPECT_LT(static_cast<double>(evaluations) / static_cast<double>(asked), most) << aspect;
    EXPECT_LT(worst, 40) << aspect;
    RecordProperty("evaluations_per_hundred", static_cast<int>(100 * evaluations / asked));
  }
}

// The worst that can be asked: exactly the gap that is there, also of needles.
TEST(GapTest, EndsWhenTheGapIsMetToTheLastBit) {
  Random random(3);
  for (int n = 0; n < 6'000; ++n) {
    const double aspect = n % 3 == 0 ? 0.5 : n % 3 == 1 ? 0.02 : 1e-4;
    const Body first = random_body(random, aspect);
    Body second = random_body(random, aspect);
    second.centre = random.uniform(first.b + second.b, first.a + second.a) * direction(random.uniform(0, 6));
    const double gap = std::max(0.0, exact_gap(first, second));
    EXPECT_LE(test_gap(first, second, gap).evaluations, 128);
  }
}

TEST(GapTest, FindsTheWidestStripNearby) {
  Random random(4);
  for (int n = 0; n < 5'000; ++n) {
    const Body first = random_body(random, 0.2);
    Body second = random_body(random, 0.2);
    second.centre = (first.a + second.a) * direction(random.uniform(0, 6));  // apart
    const Point u = widest_direction_from(first, second, normalized(second.centre));
    EXPECT_NEAR(length(u), 1, 1e-14);
    EXPECT_NEAR(strip_between(first, second, u).width, exact_gap(first, second), 1e-10);
  }
}

}  // namespace ellipse_gap_test
}  // namespace specimen
