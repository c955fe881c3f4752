#include "libmpm/material/strength.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mpm {
namespace {

using Words = std::array<std::uint32_t, 4>;

Words philox(Words counter, std::uint32_t key0, std::uint32_t key1) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32U) ^ counter[1] ^ key0,
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32U) ^ counter[3] ^ key1,
               static_cast<std::uint32_t>(product0)};
    key0 += 0x9E3779B9U;
    key1 += 0xBB67AE85U;
  }
  return counter;
}

}  // namespace

double uniform_random(std::uint64_t seed, std::uint64_t point, std::uint32_t stream) {
  const Words words =
      philox({static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(point >> 32U), stream, 0},
             static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U));
  const std::uint64_t bits = (static_cast<std::uint64_t>(words[0]) << 32U) | words[1];
  // 52 bits and a half: the middle of its interval, so neither 0 nor 1 can come out.
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;
}

double strength_factor(double random, double weibull_modulus) {
  return std::pow(-std::log(random), 1 / weibull_modulus);
}

PrincipalStress principal_stress(double xx, double yy, double xy, double normal) {
  const double mean = 0.5 * (xx + yy);
  const double radius = std::hypot(0.5 * (xx - yy), xy);
  return {mean + radius, mean - radius, normal};
}

bool fails_in_tension(const Phase& phase, double factor, const PrincipalStress& stress) {
  return phase.can_crack() && std::max(stress.first, stress.normal) > phase.tensile_scale * factor;
}

bool fails_in_shear(const Phase& phase, double factor, const PrincipalStress& stress) {
  if (!phase.can_shear()) return false;
  const double s1 = std::max(stress.first, stress.normal);
  const double s3 = std::min(stress.second, stress.normal);
  if (s3 >= 0) return false;
  const double sine = std::sin(phase.friction_angle);
  const double resistance = 2 * phase.cohesion * std::cos(phase.friction_angle) - s1 * (1 + sine);
  return -s3 * (1 - sine) > factor * resistance;
}

double shear_utilisation(const Phase& phase, double factor, const PrincipalStress& stress) {
  if (!phase.can_shear()) return 0;
  const double s1 = std::max(stress.first, stress.normal);
  const double s3 = std::min(stress.second, stress.normal);
  if (s3 >= 0) return 0;
  const double sine = std::sin(phase.friction_angle);
  return (factor * s1 * (1 + sine) - s3 * (1 - sine)) /
         (2 * factor * phase.cohesion * std::cos(phase.friction_angle));
}

double compressive_strength(const Phase& phase, double factor) {
  return 2 * factor * phase.cohesion * std::cos(phase.friction_angle) / (1 - std::sin(phase.friction_angle));
}

double tension_threshold(const Phase& phase, double factor) { return phase.tensile_scale * factor; }

double shear_onset(const Phase& phase, double factor, double largest_s1, double share) {
  if (!phase.can_shear()) return Phase::unbreakable;
  // A phase that shears but never cracks has no bound on s1: every point in compression is looked at.
  if (!(largest_s1 < Phase::unbreakable)) return 0;
  const double sine = std::sin(phase.friction_angle);
  const double resistance =
      2 * share * phase.cohesion * std::cos(phase.friction_angle) - largest_s1 * (1 + sine);
  return std::max(0.0, factor * resistance / (1 - sine));
}

namespace {

constexpr std::uint32_t stream_of_lattice = 2;

/// Standard normal number of a place of the lattice. Source: Box, Muller (1958).
double lattice_normal(std::uint64_t seed, std::int64_t row, std::int64_t col) {
  // Two numbers a place: even and odd columns of a lattice twice as wide.
  const auto counter = [&](std::int64_t which) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) << 32U) |
           static_cast<std::uint32_t>(2 * col + which);
  };
  const double radius = std::sqrt(-2 * std::log(uniform_random(seed, counter(0), stream_of_lattice)));
  return radius * std::cos(2 * std::numbers::pi * uniform_random(seed, counter(1), stream_of_lattice));
}

/// Weights of the three places of the lattice round a place, and the first of them.
struct AxisWeights {
  std::int64_t first = 0;
  double w[3] = {0, 0, 0};
};
AxisWeights axis_weights(double place) {
  const double nearest = std::floor(place + 0.5);
  const double d = place - nearest;  // in [-1/2, 1/2)
  return {static_cast<std::int64_t>(nearest) - 1,
          {0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)}};
}

double factor_of(const Phase& phase, double random) {
  return phase.can_fail() ? strength_factor(random, phase.weibull_modulus) : 1;
}

}  // namespace

double field_random(std::uint64_t seed, double x, double y, double length) {
  const AxisWeights across = axis_weights(x / length);
  const AxisWeights upwards = axis_weights(y / length);
  double sum = 0;
  double variance = 0;
  for (int b = 0; b < 3; ++b) {
    for (int a = 0; a < 3; ++a) {
      const double weight = across.w[a] * upwards.w[b];
      sum += weight * lattice_normal(seed, upwards.first + b, across.first + a);
      variance += weight * weight;
    }
  }
  const double probability = 0.5 * std::erfc(-sum / std::sqrt(2 * variance));
  return std::clamp(probability, 0x1p-53, 1 - 0x1p-53);
}

double random_of_pixel(const Scene& scene, int row, int col) {
  const double length = scene.damage.correlation_length;
  if (length <= 0) return pixel_random(scene.damage.seed, row, col);
  const double below = static_cast<double>(scene.labels.rows() - row) - 0.5;
  return field_random(scene.damage.seed, (col + 0.5) * scene.pixel_size, below * scene.pixel_size, length);
}

double random_of_extra_point(const Scene& scene, std::size_t index) {
  const double length = scene.damage.correlation_length;
  if (length <= 0) return uniform_random(scene.damage.seed, index, 1);
  const ExtraPoint& point = scene.extra_points[index];
  return field_random(scene.damage.seed, point.x, point.y, length);
}

StrengthFactors::StrengthFactors(const Scene& scene, bool keep) : scene_(scene) {
  if (!keep) return;
  kept_.reserve(static_cast<std::size_t>(scene.labels.size()));
  for (int row = 0; row < scene.labels.rows(); ++row)
    for (int col = 0; col < scene.labels.cols(); ++col)
      kept_.push_back(scene.phases[scene.labels(row, col)] ? draw_pixel(row, col) : 1);
}

double StrengthFactors::draw_pixel(int row, int col) const {
  return factor_of(*scene_.phases[scene_.labels(row, col)], random_of_pixel(scene_, row, col));
}

double StrengthFactors::of_pixel(int row, int col) const {
  if (kept_.empty()) return draw_pixel(row, col);
  return kept_[static_cast<std::size_t>(row * scene_.labels.cols() + col)];
}

double StrengthFactors::of_extra_point(std::size_t index) const {
  return factor_of(*scene_.phases[scene_.extra_points[index].phase], random_of_extra_point(scene_, index));
}

}  // namespace mpm
