/// A vector of the instruction set that a file is compiled for, and records of points in it. Private to
/// moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_kernels.hpp"
#include "libmpm/kernels/unroll.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX2__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif

/// A vector of the instruction set, a number per tile. The compiler's own vectors, so that no loop depends on
/// whether it finds out by itself that lanes are independent.
template <class Real>
struct PackOf;
template <>
struct PackOf<float> {
  typedef float type __attribute__((vector_size(vector_bytes)));
};
template <>
struct PackOf<double> {
  typedef double type __attribute__((vector_size(vector_bytes)));
};
template <class Real>
using Pack = typename PackOf<Real>::type;
template <class Real>
using Mask = decltype(Pack<Real>{} < Pack<Real>{});
template <class Real>
constexpr int lanes = vector_bytes / static_cast<int>(sizeof(Real));

template <class Real>
MPM_INLINE Pack<Real> load(const Real* from) {
  Pack<Real> pack;
  __builtin_memcpy(&pack, from, sizeof pack);
  return pack;
}
template <class Real>
MPM_INLINE void store(Real* to, const Pack<Real>& pack) {
  __builtin_memcpy(to, &pack, sizeof pack);
}
template <class Real>
MPM_INLINE Pack<Real> all(Real value) {
  return value - Pack<Real>{};
}
/// 0, 1, 2, ...
template <class Real>
MPM_INLINE Pack<Real> numbered() {
  Pack<Real> pack{};
  for (int i = 0; i < lanes<Real>; ++i) pack[i] = Real(i);
  return pack;
}
template <class Real>
MPM_INLINE bool any_of(const Mask<Real>& mask) {
  auto any = mask[0];
  for (int i = 1; i < lanes<Real>; ++i) any |= mask[i];
  return any != 0;
}

/// Record of a block of a row.
template <class Real>
MPM_INLINE Real* record_of(const TileRow<Real>& row, int block, int slot) {
  return row.records + static_cast<std::ptrdiff_t>(row.begin[block] + slot) * row.layout.fields * lanes<Real>;
}
template <class Real>
MPM_INLINE Pack<Real> field(const Real* record, int index) {
  return load<Real>(record + index * lanes<Real>);
}
template <class Real>
MPM_INLINE void set_field(Real* record, int index, const Pack<Real>& value) {
  store<Real>(record + index * lanes<Real>, value);
}

/// Asks the cache for a record that comes soon, with all that the sweeps of a step read of it.
template <class Real>
MPM_INLINE void fetch_ahead(const TileRow<Real>& row, const Real* record) {
  constexpr int records = 6;
  constexpr int fields = Field::basic_fields + 2;                  // with the two thresholds of failure
  constexpr int line = vector_bytes < 64 ? 64 / vector_bytes : 1;  // fields of a line of the cache
  const Real* ahead = record + records * row.layout.fields * lanes<Real>;
  unrolled<(fields + line - 1) / line>(
      [&](auto i) MPM_INLINE_LAMBDA { __builtin_prefetch(ahead + line * i.value * lanes<Real>); });
}

template <class Real>
MPM_INLINE double sum_of(const Pack<Real>& pack) {
  double sum = 0;
  for (int i = 0; i < lanes<Real>; ++i) sum += static_cast<double>(pack[i]);
  return sum;
}

}  // namespace
}  // namespace mpm::moving
