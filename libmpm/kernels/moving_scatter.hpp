/// From moving points to nodes (P2G): mass, momentum and internal force. Private to moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_stress.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

/// Values of a tile for its nodes, of `quantities` each, in the order of Sums.
template <class Real, int N, int quantities>
struct TileTotals {
  Pack<Real> at[N * N * quantities] = {};

  MPM_INLINE void store_in(const Sums<Real>& out, int tile) const {
    unrolled<N * N * quantities>([&](auto plane) MPM_INLINE_LAMBDA {
      store<Real>(out.values + plane.value * out.length + tile, at[plane.value]);
    });
  }
};

/// Mass and momentum, 3 quantities, or momentum alone, 2.
template <class Real, Stencil stencil, int quantities, bool affine>
MPM_INLINE void add_momentum(TileTotals<Real, nodes_of<stencil>, quantities>& sums, const TileRow<Real>& row,
                             const Real* record, const Step<Real>& step,
                             const Weights<Real, nodes_of<stencil>>& x,
                             const Weights<Real, nodes_of<stencil>>& y) {
  constexpr int n = nodes_of<stencil>;
  const Pack<Real> m = field(record, Field::mass);
  const Pack<Real> v_x = field(record, Field::vx);
  const Pack<Real> v_y = field(record, Field::vy);
  Pack<Real> at_x{}, at_y{}, c_xx{}, c_xy{}, c_yx{}, c_yy{};
  if constexpr (affine) {
    const Real* c = record + row.layout.affine * lanes<Real>;
    at_x = field(record, Field::xi);
    at_y = field(record, Field::eta);
    c_xx = step.hx * field(c, 0);
    c_xy = step.hy * field(c, 1);
    c_yx = step.hx * field(c, 2);
    c_yy = step.hy * field(c, 3);
  }
  unrolled<n>([&](auto b) MPM_INLINE_LAMBDA {
    const Pack<Real> m_row = m * y.w[b.value];
    const Pack<Real> dy = Real(node_place<stencil>(b.value)) - at_y;
    unrolled<n>([&](auto a) MPM_INLINE_LAMBDA {
      constexpr int plane = (b.value * n + a.value) * quantities;
      constexpr int momentum = plane + quantities - 2;
      const Pack<Real> m_node = m_row * x.w[a.value];
      if constexpr (quantities == 3) sums.at[plane] += m_node;
      if constexpr (affine) {
        const Pack<Real> dx = Real(node_place<stencil>(a.value)) - at_x;
        sums.at[momentum] += m_node * (v_x + c_xx * dx + c_xy * dy);
        sums.at[momentum + 1] += m_node * (v_y + c_yx * dx + c_yy * dy);
      } else {
        sums.at[momentum] += m_node * v_x;
        sums.at[momentum + 1] += m_node * v_y;
      }
    });
  });
}

/// Internal force f = -V s . grad(S), 2 quantities.
template <class Real, Stencil stencil, bool closure>
MPM_INLINE void add_force(TileTotals<Real, nodes_of<stencil>, 2>& sums, const TileRow<Real>& row,
                          const Real* record, const Step<Real>& step,
                          const Weights<Real, nodes_of<stencil>>& x,
                          const Weights<Real, nodes_of<stencil>>& y) {
  constexpr int n = nodes_of<stencil>;
  const Stress<Pack<Real>> s = carried<Real, closure>(stress_of<Real>(record), row, record, step.unilateral);
  const Pack<Real> minus_v = -field(record, Field::volume);
  const Pack<Real> v_x = minus_v * (1 / step.hx);
  const Pack<Real> v_y = minus_v * (1 / step.hy);
  const Pack<Real> xx = v_x * s.xx;
  const Pack<Real> xy_y = v_y * s.xy;
  const Pack<Real> xy_x = v_x * s.xy;
  const Pack<Real> yy = v_y * s.yy;
  unrolled<n>([&](auto b) MPM_INLINE_LAMBDA {
    const Pack<Real> fx_dx = xx * y.w[b.value];
    const Pack<Real> fx_w = xy_y * y.dw[b.value];
    const Pack<Real> fy_dx = xy_x * y.w[b.value];
    const Pack<Real> fy_w = yy * y.dw[b.value];
    unrolled<n>([&](auto a) MPM_INLINE_LAMBDA {
      constexpr int plane = (b.value * n + a.value) * 2;
      sums.at[plane] += fx_dx * x.dw[a.value] + fx_w * x.w[a.value];
      sums.at[plane + 1] += fy_dx * x.dw[a.value] + fy_w * x.w[a.value];
    });
  });
}

enum class Scattered { momentum, force, both };

/// The first sweep of each step; it prefetches the records for the following ones.
template <class Real, Stencil stencil, Scattered what, bool affine, bool closure>
void scatter(const TileRow<Real>& in, const Step<Real>& of_step, Sums<Real> momentum, Sums<Real> force) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Step<Real> step = of_step;
  for (int block = 0; block < row.blocks; ++block) {
    TileTotals<Real, n, 3> momenta;
    TileTotals<Real, n, 2> forces;
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      const Real* record = record_of(row, block, slot);
      if constexpr (what != Scattered::force) fetch_ahead<Real>(row, record);
      const auto x = weights_across<Real, stencil>(record, step.half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, step.half_size, folds);
      if constexpr (what != Scattered::force)
        add_momentum<Real, stencil, 3, affine>(momenta, row, record, step, x, y);
      if constexpr (what != Scattered::momentum)
        add_force<Real, stencil, closure>(forces, row, record, step, x, y);
    }
    const int tile = block * lanes<Real>;
    if constexpr (what != Scattered::force) momenta.store_in(momentum, tile);
    if constexpr (what != Scattered::momentum) forces.store_in(force, tile);
  }
}

}  // namespace
}  // namespace mpm::moving
