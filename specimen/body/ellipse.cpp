#include "specimen/body/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "specimen/body/ellipse_gap.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {

Inclusion make_inclusion(int id, const Ellipse& ellipse) {
  Inclusion inclusion;
  inclusion.id = id;
  inclusion.ellipse = ellipse;
  inclusion.area = area(ellipse);
  inclusion.perimeter = perimeter(ellipse);
  inclusion.equivalent_diameter = 2 * std::sqrt(ellipse.a * ellipse.b);
  constexpr double pi = std::numbers::pi;
  inclusion.orientation = ellipse.angle - pi * std::floor(ellipse.angle / pi);
  if (inclusion.orientation >= pi) inclusion.orientation = 0;  // a tiny negative angle rounds up to pi
  return inclusion;
}

double area(const Ellipse& e) { return std::numbers::pi * e.a * e.b; }

// Gauss: perimeter = 2 pi / M (a^2 - sum 2^(n-1) c_n^2), M the arithmetic-geometric mean of a and b.
double perimeter(const Ellipse& e) {
  double a = e.a, b = e.b;
  double sum = a * a, weight = 0.5, c2 = a * a - b * b;
  while (weight * c2 > 1e-17 * e.a * e.a) {
    sum -= weight * c2;
    const double mean = (a + b) / 2, half_difference = (a - b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    c2 = half_difference * half_difference;
    weight *= 2;
  }
  return 2 * std::numbers::pi * sum / a;
}

bool contains(const Ellipse& e, Point p) {
  const Rotation axis = rotation_by(e.angle);
  const Point d = p - Point{e.x, e.y};
  const double along = (d.x * axis.cos + d.y * axis.sin) / e.a;
  const double across = (d.y * axis.cos - d.x * axis.sin) / e.b;
  return along * along + across * across <= 1;
}

Point half_extent(const Ellipse& e) {
  const Rotation axis = rotation_by(e.angle);
  const auto reach = [](double p, double q) { return std::sqrt(p * p + q * q); };
  return {reach(e.a * axis.cos, e.b * axis.sin), reach(e.a * axis.sin, e.b * axis.cos)};
}

bool separated(const Ellipse& first, const Ellipse& second, double gap) {
  return test_gap(body_of(first), body_of(second), gap).separated;
}

double gap_between(const Ellipse& first, const Ellipse& second) {
  return exact_gap(body_of(first), body_of(second));
}

namespace {

// Taylor series of sin on [-pi/4, pi/4]; the first term left out is 5e-17 of the value.
double sine_near_zero(double x) {
  const double x2 = x * x;
  double sum = 0;
  for (int n = 17; n >= 3; n -= 2) sum = (1 + sum) * (-x2 / (n * (n - 1)));
  return x + x * sum;
}

// Taylor series of cos on [-pi/4, pi/4]; the first term left out is 2e-18.
double cosine_near_zero(double x) {
  const double x2 = x * x;
  double sum = 0;
  for (int n = 16; n >= 2; n -= 2) sum = (1 + sum) * (-x2 / (n * (n - 1)));
  return 1 + sum;
}

}  // namespace

Rotation rotation_by(double angle) {
  constexpr double quarter = std::numbers::pi / 2;
  // pi/2 in two parts: the first has 33 bits, so that a small multiple of it is exact.
  constexpr double quarter_high = 1.57079632673412561417e+00;
  constexpr double quarter_low = 6.07710050650619224932e-11;
  const double within = std::remainder(angle, 4 * quarter);
  const double quarters = std::nearbyint(within / quarter);
  const double rest = (within - quarters * quarter_high) - quarters * quarter_low;
  const double s = sine_near_zero(rest), c = cosine_near_zero(rest);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

std::vector<std::vector<Point>> loops_of(const std::vector<Point>& contour) {
  if (contour.empty()) return {};
  std::vector<std::vector<Point>> loops;
  const Point home = contour.front();
  // The first one needs no end of its own where it is the only one.
  const auto end = std::find(contour.begin() + 1, contour.end(), home);
  loops.emplace_back(contour.begin(), end);
  for (auto at = end; at != contour.end() && at + 1 != contour.end();) {
    const auto start = at + 1;
    const auto close = std::find(start + 1, contour.end(), *start);
    loops.emplace_back(start, close);
    at = close == contour.end() ? close : close + 1;  // home again
  }
  return loops;
}

std::vector<Point> contour_of(const std::vector<std::vector<Point>>& loops) {
  std::vector<Point> contour;
  for (const std::vector<Point>& loop : loops) {
    contour.insert(contour.end(), loop.begin(), loop.end());
    if (loops.size() == 1) break;
    if (&loop != &loops.front()) contour.push_back(loop.front());
    contour.push_back(loops.front().front());
  }
  return contour;
}

}  // namespace specimen
