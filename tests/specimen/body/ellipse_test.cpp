#include "specimen/body/ellipse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {
namespace ellipse_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr double pi = std::numbers::pi;

Point on_boundary(const Ellipse& e, double parameter) {
  const Point axis{std::cos(e.angle), std::sin(e.angle)};
  return Point{e.x, e.y} + (e.a * std::cos(parameter)) * axis +
         (e.b * std::sin(parameter)) * turned_left(axis);
}

// Two ellipses of 5 to 20 mm whose centres lie where only an exact test can tell.
std::pair<Ellipse, Ellipse> random_pair(Random& random, double aspect_min, double gap) {
  const auto one = [&] {
    const double d = random.uniform(5e-3, 20e-3), root = std::sqrt(random.uniform(aspect_min, 1));
    return Ellipse{0, 0, d / 2 / root, d / 2 * root, random.uniform(0, pi)};
  };
  std::pair<Ellipse, Ellipse> pair{one(), one()};
  const double near = pair.first.b + pair.second.b, far = pair.first.a + pair.second.a + gap;
  const double distance = random.uniform(near, far), direction = random.uniform(0, 2 * pi);
  pair.second.x = distance * std::cos(direction);
  pair.second.y = distance * std::sin(direction);
  return pair;
}

constexpr int samples = 48;

std::array<Point, samples> boundary_of(const Ellipse& e) {
  static const auto circle = [] {
    std::array<Point, samples> points;
    for (int i = 0; i < samples; ++i)
      points[i] = {std::cos(2 * pi * i / samples), std::sin(2 * pi * i / samples)};
    return points;
  }();
  const Point axis{std::cos(e.angle), std::sin(e.angle)};
  std::array<Point, samples> points;
  for (int i = 0; i < samples; ++i)
    points[i] = Point{e.x, e.y} + (e.a * circle[i].x) * axis + (e.b * circle[i].y) * turned_left(axis);
  return points;
}

bool any_inside(const std::array<Point, samples>& points, const Ellipse& e) {
  const Point axis{std::cos(e.angle), std::sin(e.angle)};
  return std::any_of(points.begin(), points.end(), [&](Point p) {
    const Point d = p - Point{e.x, e.y};
    const double x = dot(axis, d) / e.a, y = cross(axis, d) / e.b;
    return x * x + y * y < 1;
  });
}

// Distance of two boundaries near the parameters s and t of their points, by halving the steps.
double refined_gap(const Ellipse& first, const Ellipse& second, double s, double t) {
  const auto distance = [&](double at_first, double at_second) {
    return length(on_boundary(first, at_first) - on_boundary(second, at_second));
  };
  double least = distance(s, t);
  for (double step = pi / samples; step > 1e-9;) {
    bool better = false;
    for (const auto& [ds, dt] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const double here = distance(s + ds * step, t + dt * step);
      if (here >= least) continue;
      least = here;
      s += ds * step;
      t += dt * step;
      better = true;
      break;
    }
    if (!better) step /= 2;
  }
  return least;
}

// Distance between two boundaries by sampling both, then by halving the steps round the nearest samples.
// Empty when a sample of one lies inside the other. Not refined where the samples alone tell whether the
// distance is above or below `asked`.
std::optional<double> sampled_gap(const Ellipse& first, const Ellipse& second, double asked = not_a_number) {
  const auto p = boundary_of(first), q = boundary_of(second);
  if (any_inside(p, second) || any_inside(q, first)) return std::nullopt;
  double square = infinite;
  int s = 0, t = 0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double here = dot(p[i] - q[j], p[i] - q[j]);
      if (here >= square) continue;
      square = here;
      s = i;
      t = j;
    }
  }
  const double least = std::sqrt(square), off = (first.a + second.a) * pi / samples;
  if (least < asked || least - off > asked) return least;
  return refined_gap(first, second, 2 * pi * s / samples, 2 * pi * t / samples);
}

// The paper's test: with the first ellipse a unit circle A and the second B, det(lambda A + B) has two
// distinct positive roots just when they are separated (Wang, Wang, Kim 2001).
bool separated_by_polynomial(const Ellipse& first, const Ellipse& second) {
  const double c1 = std::cos(first.angle), s1 = std::sin(first.angle);
  const double c2 = std::cos(second.angle), s2 = std::sin(second.angle);
  // x = M w + c in the frame where the first ellipse is the unit circle, |w| <= 1 being the second.
  const auto into = [&](Point v) {
    return Point{(c1 * v.x + s1 * v.y) / first.a, (c1 * v.y - s1 * v.x) / first.b};
  };
  const Point u = into({second.a * c2, second.a * s2}), v = into({-second.b * s2, second.b * c2});
  const Point c = into({second.x - first.x, second.y - first.y});
  const double det = cross(u, v);
  // Inverse of M, then B = M^-T M^-1 with the centre moved to c.
  const double i11 = v.y / det, i12 = -v.x / det, i21 = -u.y / det, i22 = u.x / det;
  const double xx = i11 * i11 + i21 * i21, xy = i11 * i12 + i21 * i22, yy = i12 * i12 + i22 * i22;
  const double px = -(xx * c.x + xy * c.y), py = -(xy * c.x + yy * c.y);
  const double w = -(px * c.x + py * c.y) - 1;
  const auto value = [&](double l) {
    return (l + xx) * ((l + yy) * (w - l) - py * py) - xy * (xy * (w - l) - py * px) +
           px * (xy * py - (l + yy) * px);
  };
  // A cubic that falls from +infinity; positive at some lambda > 0 beyond a negative stretch, or never.
  const double c2_ = w - xx - yy;
  const double c1_ = (xx + yy) * w - xx * yy - px * px - py * py + xy * xy;
  // value = -l^3 + c2_ l^2 + c1_ l + value(0); its local maximum decides.
  const double discriminant = c2_ * c2_ + 3 * c1_;
  if (discriminant <= 0) return false;
  const double top = (c2_ + std::sqrt(discriminant)) / 3;
  return top > 0 && value(top) > 0;
}

TEST(Ellipse, CircleHasItsAreaPerimeterAndExtent) {
  const Ellipse circle{1, 2, 3, 3, 0.7};
  EXPECT_DOUBLE_EQ(area(circle), 9 * pi);
  EXPECT_DOUBLE_EQ(perimeter(circle), 6 * pi);
  EXPECT_NEAR(half_extent(circle).x, 3, 1e-15);
  EXPECT_NEAR(half_extent(circle).y, 3, 1e-15);
}

// 9.688448220547675 is the perimeter of the ellipse 2 by 1; the other limit is a line walked twice.
TEST(Ellipse, PerimeterIsExactFromCircleToNeedle) {
  EXPECT_NEAR(perimeter({0, 0, 2, 1, 0}), 9.688448220547675, 1e-14);
  EXPECT_NEAR(perimeter({0, 0, 1, 1e-9, 0}), 4, 1e-14);
  for (const double aspect : {0.02, 0.1, 0.5, 0.9, 0.9999}) {
    double sum = 0;  // the trapezoidal rule converges beyond all powers on a period
    constexpr int count = 4096;
    for (int i = 0; i < count; ++i) {
      const double t = 2 * pi * (i + 0.5) / count;
      sum += std::hypot(std::sin(t), aspect * std::cos(t)) * 2 * pi / count;
    }
    EXPECT_NEAR(perimeter({0, 0, 1, aspect, 0}), sum, 1e-12) << aspect;
  }
}

TEST(Ellipse, HalfExtentIsTheFarthestPoint) {
  const Ellipse e{0.1, -0.2, 0.03, 0.01, 0.6};
  double right = -1, top = -1;
  for (int i = 0; i < 100'000; ++i) {
    const Point p = on_boundary(e, 2 * pi * i / 100'000);
    right = std::max(right, p.x);
    top = std::max(top, p.y);
  }
  EXPECT_NEAR(e.x + half_extent(e).x, right, 1e-10);
  EXPECT_NEAR(e.y + half_extent(e).y, top, 1e-10);
}

TEST(Ellipse, ContainsWhatTheSumOfFocalDistancesSays) {
  const Ellipse e{0.1, -0.2, 0.03, 0.01, 0.6};
  const double focus = std::sqrt(e.a * e.a - e.b * e.b);
  const Point axis{std::cos(e.angle), std::sin(e.angle)}, centre{e.x, e.y};
  Random random(3);
  for (int n = 0; n < 10'000; ++n) {
    const Point p{e.x + random.uniform(-0.03, 0.03), e.y + random.uniform(-0.03, 0.03)};
    const double sum = length(p - (centre + focus * axis)) + length(p - (centre - focus * axis));
    if (std::abs(sum - 2 * e.a) < 1e-12) continue;
    EXPECT_EQ(contains(e, p), sum < 2 * e.a);
  }
}

void expect_exact(double aspect_min, int count) {
  Random random(11);
  constexpr double gap = 0.5e-3, sampling = 1e-8;
  int apart = 0, near = 0, overlapping = 0;
  for (int n = 0; n < count; ++n) {
    const auto [first, second] = random_pair(random, aspect_min, gap);
    const std::optional<double> sampled = sampled_gap(first, second, gap);
    const bool answer = separated(first, second, gap);
    // Samples may miss a shallow overlap; then the boundaries cross and the sampled gap is nearly zero.
    if (!sampled || *sampled < gap - sampling) {
      ASSERT_FALSE(answer) << n;
      ++(sampled && *sampled > sampling ? near : overlapping);
    } else if (*sampled > gap + sampling) {
      ASSERT_TRUE(answer) << n;
      ++apart;
    }
  }
  EXPECT_GT(apart, count / 5);
  EXPECT_GT(near, count / 50);
  EXPECT_GT(overlapping, count / 5);
}

TEST(Gap, AnswersAsSampledBoundariesDo) { expect_exact(0.5, 60'000); }
TEST(Gap, AnswersAsSampledBoundariesDoForThinEllipses) { expect_exact(0.02, 40'000); }

TEST(Gap, AnswersAsThePolynomialDoesForTouching) {
  Random random(5);
  int apart = 0, overlapping = 0;
  for (int n = 0; n < 100'000; ++n) {
    const auto [first, second] = random_pair(random, n % 2 == 0 ? 0.5 : 0.1, 0);
    const bool expected = separated_by_polynomial(first, second);
    if (separated(first, second, 0) == expected) {
      ++(expected ? apart : overlapping);
      continue;
    }
    // The roots of the polynomial coincide at touching and are good for half of the digits only.
    ASSERT_LT(std::abs(gap_between(first, second)), 1e-9) << n;
  }
  EXPECT_GT(apart, 20'000);
  EXPECT_GT(overlapping, 20'000);
}

TEST(Gap, IsTheSampledDistance) {
  Random random(13);
  int compared = 0;
  for (int n = 0; n < 2'000; ++n) {
    const auto [first, second] = random_pair(random, n % 2 == 0 ? 0.5 : 0.02, 2e-3);
    const std::optional<double> sampled = sampled_gap(first, second);
    if (!sampled || *sampled < 1e-6) continue;
    ASSERT_NEAR(gap_between(first, second), *sampled, 1e-9) << n;
    ++compared;
  }
  EXPECT_GT(compared, 400);
}

TEST(Gap, DecidesRightBesideTheGapItself) {
  Random random(17);
  for (int n = 0; n < 5'000; ++n) {
    const auto [first, second] = random_pair(random, n % 2 == 0 ? 0.5 : 0.02, 2e-3);
    const double gap = gap_between(first, second), hair = 1e-15;
    if (gap <= hair) continue;
    ASSERT_TRUE(separated(first, second, gap - hair)) << n;
    ASSERT_FALSE(separated(first, second, gap + hair)) << n;
  }
}

TEST(Gap, OfOverlappingEllipsesIsTheLeastTranslationApart) {
  Random random(19);
  int compared = 0;
  for (int n = 0; n < 500; ++n) {
    auto [first, second] = random_pair(random, n % 2 == 0 ? 0.5 : 0.05, 0);
    if (n % 10 == 0) second.x = second.y = 0;  // concentric
    const double depth = -gap_between(first, second);
    if (depth <= 0) continue;
    ++compared;
    // No direction of 720 parts them by a shorter way, and one of them needs hardly more.
    bool parted = false;
    for (int k = 0; k < 720; ++k) {
      const double t = 2 * pi * k / 720;
      Ellipse shorter = second, longer = second;
      shorter.x += depth * (1 - 1e-9) * std::cos(t);
      shorter.y += depth * (1 - 1e-9) * std::sin(t);
      longer.x += (depth + 1e-4) * std::cos(t);
      longer.y += (depth + 1e-4) * std::sin(t);
      ASSERT_FALSE(separated(first, shorter, 0)) << n;
      parted = parted || separated(first, longer, 0);
    }
    ASSERT_TRUE(parted) << n;
  }
  EXPECT_GT(compared, 150);
}

TEST(Gap, OfCirclesIsThatOfTheirCentres) {
  const Ellipse circle{0, 0, 2, 2, 0.3};
  EXPECT_NEAR(gap_between(circle, {5, 0, 1, 1, 2}), 2, 1e-14);
  EXPECT_NEAR(gap_between(circle, {0, 2.5, 1, 1, 0}), -0.5, 1e-14);
  EXPECT_TRUE(separated(circle, {3, 0, 1, 1, 0}, 0));  // they touch
  EXPECT_FALSE(separated(circle, {3, 0, 1, 1, 0}, 1e-12));
}

TEST(Gap, OfEllipsesInOneAnotherIsNegative) {
  const Ellipse large{0, 0, 10, 5, 0.4}, small{1, 1, 1, 0.2, 1};
  EXPECT_FALSE(separated(large, small, 0));
  EXPECT_FALSE(separated(small, large, 0));
  EXPECT_LT(gap_between(large, small), -4);
  EXPECT_FALSE(separated(large, large, 0));
  EXPECT_NEAR(gap_between(large, large), -10, 1e-12);  // twice the short semi-axis
}

TEST(Gap, IsTheSameBothWaysAndWhenMovedOrTurned) {
  Random random(23);
  for (int n = 0; n < 1'000; ++n) {
    const auto [first, second] = random_pair(random, 0.1, 2e-3);
    const double gap = gap_between(first, second);
    ASSERT_NEAR(gap_between(second, first), gap, 1e-15);
    const double turn = random.uniform(0, 2 * pi), c = std::cos(turn), s = std::sin(turn);
    const auto moved = [&](Ellipse e) {
      return Ellipse{c * e.x - s * e.y + 0.05, s * e.x + c * e.y - 0.02, e.a, e.b, e.angle + turn};
    };
    ASSERT_NEAR(gap_between(moved(first), moved(second)), gap, 1e-15);
  }
}

// What growing both by half the gap and testing for overlap would wrongly let pass.
TEST(Gap, IsNotThatOfGrownEllipses) {
  Random random(29);
  constexpr double gap = 0.5e-3;
  int let_pass = 0;
  for (int n = 0; n < 20'000; ++n) {
    const auto [first, second] = random_pair(random, 0.5, gap);
    Ellipse p = first, q = second;
    for (Ellipse* e : {&p, &q}) {
      e->a += gap / 2;
      e->b += gap / 2;
    }
    if (separated(first, second, gap)) {
      ASSERT_TRUE(separated(p, q, 0));
    } else if (separated(p, q, 0)) {
      ++let_pass;
    }
  }
  EXPECT_GT(let_pass, 0);
}

}  // namespace ellipse_test
}  // namespace specimen
