#include "specimen/describe/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace specimen {
namespace {

double rayleigh_probability(double strength, double count) {
  const double z = count * strength * strength;
  const double first = (2 * z - z * z) / (4 * count);
  const double second = (24 * z - 132 * z * z + 76 * z * z * z - 9 * z * z * z * z) / (288 * count * count);
  return std::clamp(std::exp(-z) * (1 + first - second), 0.0, 1.0);
}

}  // namespace

Orientation mean_orientation(const std::vector<WeightedAxis>& axes) {
  double along = 0, across = 0, sum = 0, squares = 0;
  for (const WeightedAxis& axis : axes) {
    along += axis.weight * std::cos(2 * axis.angle);
    across += axis.weight * std::sin(2 * axis.angle);
    sum += axis.weight;
    squares += axis.weight * axis.weight;
  }
  if (!(sum > 0)) return {};
  Orientation result;
  result.strength = std::hypot(along, across) / sum;
  result.direction = std::atan2(across, along) / 2;
  if (result.direction < 0) result.direction += std::numbers::pi;
  if (result.direction >= std::numbers::pi) result.direction = 0;  // a tiny negative angle rounds up to pi
  result.probability = rayleigh_probability(result.strength, sum * sum / squares);
  return result;
}

}  // namespace specimen
