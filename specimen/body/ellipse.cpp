#include "specimen/body/ellipse.hpp"

#include <cmath>
#include <numbers>

#include "specimen/body/ellipse_gap.hpp"
#include "specimen/body/plane.hpp"

namespace specimen {

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

}  // namespace specimen
