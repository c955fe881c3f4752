/// Loops that the compiler unrolls. Always inlined, so that no copy compiled for one instruction set is ever
/// called from another.
#pragma once

#define MPM_INLINE __attribute__((always_inline)) inline
#define MPM_INLINE_LAMBDA __attribute__((always_inline))

namespace mpm {

template <int I>
struct Index {
  static constexpr int value = I;
};

/// body(Index<0>{}), body(Index<1>{}), ..., body(Index<N - 1>{}).
template <int N, int I = 0, class Body>
MPM_INLINE void unrolled(Body&& body) {
  if constexpr (I < N) {
    body(Index<I>{});
    unrolled<N, I + 1>(body);
  }
}

}  // namespace mpm
