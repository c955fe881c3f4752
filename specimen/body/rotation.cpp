#include "specimen/body/rotation.hpp"

#include <cmath>
#include <numbers>

namespace specimen {
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

}  // namespace specimen
