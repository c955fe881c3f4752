/// Vectors of the instruction set, records of points, and shape functions for a vector of points at a time.
/// Private to moving_kernels.cpp.
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

/// A vector of the instruction set, one number per tile. These are vector types of the compiler, so that no
/// loop depends on auto-vectorisation.
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

/// Prefetches a record that is needed soon.
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

namespace {  // a copy for each instruction set

/// Weights of the nodes of a tile along one axis, and their derivatives by the place in cells.
template <class Real, int N>
struct Weights {
  Pack<Real> w[N], dw[N];
};

/// Nodes of a tile along an axis.
template <Stencil stencil>
constexpr int nodes_of = stencil == Stencil::linear ? 2 : 3;

/// @param at  place in the tile [-].   @param half_size  of the point, over the size of a cell.
template <class Real, Stencil stencil>
MPM_INLINE Weights<Real, nodes_of<stencil>> weights(const Pack<Real>& at, Real half_size) {
  Weights<Real, nodes_of<stencil>> result;
  if constexpr (stencil == Stencil::linear) {
    result.w[0] = 1 - at;
    result.w[1] = at;
    result.dw[0] = all<Real>(-1);
    result.dw[1] = all<Real>(1);
  } else {
    // The tent averaged over the width of the point. Its part beyond the middle node grows as a parabola
    // while the point lies over that node, and linearly from there on; a point as wide as a cell always does:
    // that is the quadratic B-spline.
    const Real l = half_size;
    const Pack<Real> d = at - Real(0.5);
    const Pack<Real> upper = all<Real>(l);
    const Pack<Real> cut = d < upper ? d : upper;
    const Pack<Real> t = cut > -upper ? cut : -upper;
    const Pack<Real> zero{};
    const Pack<Real> beyond = d - t;
    const Real scale = Real(0.5) / l;
    const Pack<Real> right = (l + t) * scale;
    const Pack<Real> left = (l - t) * scale;
    result.w[2] = Real(0.5) * (l + t) * right + (beyond > zero ? beyond : zero);
    result.w[0] = Real(0.5) * (l - t) * left + (beyond < zero ? -beyond : zero);
    result.w[1] = 1 - result.w[0] - result.w[2];
    result.dw[0] = -left;
    result.dw[2] = right;
    result.dw[1] = left - right;
  }
  return result;
}

/// Lanes whose tiles are folded at their left and right, and whether the rows are below and above.
template <class Real>
struct BlockFolds {
  Pack<Real> left{}, right{};  ///< 1 for a tile that is, else 0
  bool across = false, lower = false, upper = false;
};
template <class Real, Stencil stencil>
MPM_INLINE BlockFolds<Real> folds_of(const TileRow<Real>& row, int block) {
  BlockFolds<Real> folds;
  if constexpr (stencil == Stencil::quadratic) {
    const int first = block * lanes<Real>;
    const auto lane_of = [&](int tile) MPM_INLINE_LAMBDA {
      const Pack<Real> distance = numbered<Real>() - Real(tile - first);
      return distance == Pack<Real>{} ? all<Real>(1) : Pack<Real>{};
    };
    const auto is_here = [&](int tile)
                             MPM_INLINE_LAMBDA { return tile >= first && tile < first + lanes<Real>; };
    folds.left = lane_of(row.folds.left);
    folds.right = lane_of(row.folds.right);
    folds.across = is_here(row.folds.left) || is_here(row.folds.right);
    folds.lower = row.folds.lower;
    folds.upper = row.folds.upper;
  }
  return folds;
}

/// Replaces the weight of the first node by linear extrapolation from the others; likewise for the last node.
template <class Real>
MPM_INLINE void fold(Pack<Real> (&w)[3], const Pack<Real>& first, const Pack<Real>& last) {
  const Pack<Real> low = first * w[0];
  const Pack<Real> high = last * w[2];
  w[0] -= low + high;
  w[1] += 2 * (low + high);
  w[2] -= high + low;
}
template <class Real>
MPM_INLINE void fold(Pack<Real> (&)[2], const Pack<Real>&, const Pack<Real>&) {}  // linear shapes end there

template <class Real, int N>
MPM_INLINE void fold_across(Pack<Real> (&w)[N], const BlockFolds<Real>& folds) {
  if (folds.across) fold<Real>(w, folds.left, folds.right);
}
template <class Real, int N>
MPM_INLINE void fold_upwards(Pack<Real> (&w)[N], const BlockFolds<Real>& folds) {
  if (folds.lower || folds.upper)
    fold<Real>(w, all<Real>(folds.lower ? 1 : 0), all<Real>(folds.upper ? 1 : 0));
}

/// Weights of a point across and upwards, with the folds at supports.
template <class Real, Stencil stencil>
MPM_INLINE Weights<Real, nodes_of<stencil>> weights_across(const Real* record, Real half_size,
                                                           const BlockFolds<Real>& folds) {
  auto x = weights<Real, stencil>(load<Real>(record + Field::xi * lanes<Real>), half_size);
  fold_across<Real>(x.w, folds);
  fold_across<Real>(x.dw, folds);
  return x;
}
template <class Real, Stencil stencil>
MPM_INLINE Weights<Real, nodes_of<stencil>> weights_upwards(const Real* record, Real half_size,
                                                            const BlockFolds<Real>& folds) {
  auto y = weights<Real, stencil>(load<Real>(record + Field::eta * lanes<Real>), half_size);
  fold_upwards<Real>(y.w, folds);
  fold_upwards<Real>(y.dw, folds);
  return y;
}

/// Place of node `i` of a tile along an axis, from the edge of the tile, in cells.
template <Stencil stencil>
constexpr double node_place(int i) {
  return stencil == Stencil::linear ? i : i - 0.5;
}

/// Variance of the weights along an axis [-]; 1/4 for the B-spline.
template <class Real, int N>
MPM_INLINE Pack<Real> variance(const Weights<Real, N>& x, const Pack<Real>& at) {
  const Pack<Real> d = at - Real(0.5);
  return x.w[0] + x.w[2] - d * d;
}

/// A field over the tiles of a block: its values at their nodes, [row][column].
template <class Real, int N>
struct TileNodes {
  Pack<Real> at[N][N];
};
/// Between the four nodes of a linear shape the field is corner + across x + upwards y + twist x y.
template <class Real>
struct TileNodes<Real, 2> {
  Pack<Real> corner, across, upwards, twist;
};
template <class Real, int N>
MPM_INLINE TileNodes<Real, N> load_nodes(const Real* first, std::ptrdiff_t stride, int tile) {
  const Real* node = first + tile;
  TileNodes<Real, N> nodes;
  if constexpr (N == 2) {
    nodes.corner = load<Real>(node);
    nodes.across = load<Real>(node + 1) - nodes.corner;
    nodes.upwards = load<Real>(node + stride) - nodes.corner;
    nodes.twist = load<Real>(node + stride + 1) - load<Real>(node + stride) - nodes.across;
  } else {
    unrolled<N>([&](auto b) MPM_INLINE_LAMBDA {
      unrolled<N>([&](auto a) MPM_INLINE_LAMBDA {
        nodes.at[b.value][a.value] = load<Real>(node + b.value * stride + a.value);
      });
    });
  }
  return nodes;
}

/// Sum over the nodes of weight by value.
template <class Real>
MPM_INLINE Pack<Real> weighted(const TileNodes<Real, 3>& nodes, const Pack<Real> (&wx)[3],
                               const Pack<Real> (&wy)[3]) {
  Pack<Real> sum{};
  unrolled<3>([&](auto b) MPM_INLINE_LAMBDA {
    Pack<Real> row{};
    unrolled<3>([&](auto a) MPM_INLINE_LAMBDA { row += wx[a.value] * nodes.at[b.value][a.value]; });
    sum += wy[b.value] * row;
  });
  return sum;
}

/// Value of the field at the points.
template <class Real>
MPM_INLINE Pack<Real> interpolated(const TileNodes<Real, 3>& f, const Weights<Real, 3>& x,
                                   const Weights<Real, 3>& y) {
  return weighted<Real>(f, x.w, y.w);
}
template <class Real>
MPM_INLINE Pack<Real> interpolated(const TileNodes<Real, 2>& f, const Weights<Real, 2>& x,
                                   const Weights<Real, 2>& y) {
  return f.corner + f.across * x.w[1] + y.w[1] * (f.upwards + f.twist * x.w[1]);
}

/// Its slopes there, over the width and the height of a cell.
template <class Real>
struct Slopes {
  Pack<Real> across, upwards;
};
template <class Real>
MPM_INLINE Slopes<Real> slopes(const TileNodes<Real, 3>& f, const Weights<Real, 3>& x,
                               const Weights<Real, 3>& y) {
  return {weighted<Real>(f, x.dw, y.w), weighted<Real>(f, x.w, y.dw)};
}
template <class Real>
MPM_INLINE Slopes<Real> slopes(const TileNodes<Real, 2>& f, const Weights<Real, 2>& x,
                               const Weights<Real, 2>& y) {
  return {f.across + f.twist * y.w[1], f.upwards + f.twist * x.w[1]};
}

}  // namespace
}  // namespace mpm::moving
