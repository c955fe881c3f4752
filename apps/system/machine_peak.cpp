#include "apps/system/machine.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <vector>

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

template <class Work>
double best_seconds(int repeats, Work&& work) {
  double best = 1e30;
  for (int i = 0; i < repeats; ++i) {
    const auto start = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

// Enough independent multiply-adds to hide their latency on two units, and few enough to stay in registers.
constexpr int chains = 12;
constexpr std::int64_t rounds = 2'000'000;

/// Sum of chains of multiply-adds on vectors of the given width, which must be that of the registers: a wider
/// one is passed through memory.
template <class Real, int bytes>
struct Chains {
  using Vector [[gnu::vector_size(bytes)]] = Real;
  static constexpr int lanes = bytes / static_cast<int>(sizeof(Real));

  [[gnu::always_inline]] static inline Real run(Real factor) {
    Vector sums[chains];
    const Vector f = factor - Vector{};
    for (int c = 0; c < chains; ++c) sums[c] = f + Real(c);
    for (std::int64_t i = 0; i < rounds; ++i) {
#pragma GCC unroll 12
      for (int c = 0; c < chains; ++c) sums[c] = sums[c] * f + f;
    }
    Real total = 0;
    for (const auto& sum : sums)
      for (int lane = 0; lane < lanes; ++lane) total += sum[lane];
    return total;
  }
};

template <class Real>
Real chain_baseline(Real factor) {
  return Chains<Real, 16>::run(factor);
}
#ifdef __x86_64__
#ifdef __clang__
#define MESOPIX_AVX512 "avx512f,avx512vl,avx512dq,fma"  // Clang takes the width from the vectors
#else
#define MESOPIX_AVX512 "avx512f,avx512vl,avx512dq,fma,prefer-vector-width=512"
#endif
template <class Real>
[[gnu::target(MESOPIX_AVX512)]] Real chain_avx512(Real factor) {
  return Chains<Real, 64>::run(factor);
}
template <class Real>
[[gnu::target("avx2,fma")]] Real chain_avx2(Real factor) {
  return Chains<Real, 32>::run(factor);
}
#endif

template <class Real>
double peak_flops() {
  Real (*chain)(Real) = chain_baseline<Real>;
  int bytes = 16;
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
    chain = chain_avx512<Real>;
    bytes = 64;
  } else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    chain = chain_avx2<Real>;
    bytes = 32;
  }
#endif
  volatile Real sink = 0;
  const double seconds = best_seconds(5, [&] { sink = chain(Real(1e-9)); });
  const double lanes = bytes / static_cast<double>(sizeof(Real));
  return 2.0 * lanes * chains * static_cast<double>(rounds) / seconds;
}

double copy_bandwidth() {
  constexpr std::size_t bytes = std::size_t{256} << 20U;
  std::vector<char> from(bytes, 1);
  std::vector<char> to(bytes, 2);
  const double seconds = best_seconds(4, [&] { std::memcpy(to.data(), from.data(), bytes); });
  return 2.0 * static_cast<double>(bytes) / seconds;
}

}  // namespace

double measure_flops_double() { return peak_flops<double>(); }

MachinePeak measure_machine_peak() { return {peak_flops<double>(), peak_flops<float>(), copy_bandwidth()}; }

}  // namespace app
