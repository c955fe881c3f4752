/// Selection of the kernels for this machine; and flushing of subnormal numbers, which are up to a hundred
/// times slower than others.
#pragma once

#include <string_view>
#include <vector>

#include "libmpm/kernels/equilibrium_kernels.hpp"
#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/kernels/moving_kernels.hpp"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace mpm {

/// During its lifetime this thread treats numbers below 2.2e-308 (1.2e-38 in 32 bits) as zero. Wave fronts
/// and damped waves contain many such numbers. Does nothing on processors other than x86-64.
class FlushToZero {
 public:
#ifdef __x86_64__
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | flush_operands); }
  ~FlushToZero() { _mm_setcsr((_mm_getcsr() & ~(flush_results | flush_operands)) | kept()); }
#else
  FlushToZero() {}
  ~FlushToZero() {}
#endif
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
#ifdef __x86_64__
  static constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;
  [[nodiscard]] unsigned kept() const { return before_ & (flush_results | flush_operands); }
  unsigned before_;
#endif
};

/// The kernels that this processor can run, fastest first; never empty.
[[nodiscard]] std::vector<const kernels::Kernels*> available_kernels();

/// The kernels of that name, or the fastest ones for an empty name.
/// @throws Error if this processor does not support them.
[[nodiscard]] const kernels::Kernels& chosen_kernels(std::string_view name);

/// The kernels of equilibrium of the same instruction set.
[[nodiscard]] const equilibrium::Kernels& chosen_equilibrium_kernels(std::string_view name);

/// The kernels of moving points of the same instruction set.
[[nodiscard]] const moving::Kernels& chosen_moving_kernels(std::string_view name);

}  // namespace mpm
