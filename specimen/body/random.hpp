/// Seeded random numbers, the same on every machine.
#pragma once

#include <cstdint>
#include <random>

namespace specimen {

/// Uniform numbers from a 64-bit Mersenne twister. The standard fixes the twister's raw output but leaves
/// its distributions to the library, so the step to doubles is made here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Uniform in [low, high].
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace specimen
