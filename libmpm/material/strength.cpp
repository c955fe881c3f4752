#include "libmpm/material/strength.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

double tension_threshold(const Phase& phase, double factor) { return phase.tensile_scale * factor; }

double shear_onset(const Phase& phase, double factor, double largest_s1) {
  if (!phase.can_shear()) return Phase::unbreakable;
  // A phase that shears but never cracks has no bound on s1: every point in compression is looked at.
  if (!(largest_s1 < Phase::unbreakable)) return 0;
  const double sine = std::sin(phase.friction_angle);
  const double resistance = 2 * phase.cohesion * std::cos(phase.friction_angle) - largest_s1 * (1 + sine);
  return std::max(0.0, factor * resistance / (1 - sine));
}

}  // namespace mpm
