/// From nodes to moving points (G2P): their velocity, and for MUSL the momentum mapped back to the nodes.
/// Private to moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_scatter.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

/// B over the variance of the weights, for linear shapes the gradient itself: the gradient of the velocity
/// [1/s].
template <class Real, Stencil stencil>
MPM_INLINE void gather_affine(const TileRow<Real>& row, Real* record, const Step<Real>& step,
                              const TileNodes<Real, nodes_of<stencil>>& nodes_x,
                              const TileNodes<Real, nodes_of<stencil>>& nodes_y,
                              const Weights<Real, nodes_of<stencil>>& x,
                              const Weights<Real, nodes_of<stencil>>& y, const BlockFolds<Real>& folds) {
  Real* affine = record + row.layout.affine * lanes<Real>;
  if constexpr (stencil == Stencil::linear) {
    const Gradient<Real> g = gradient<Real>(nodes_x, nodes_y, x, y, 1 / step.hx, 1 / step.hy);
    set_field<Real>(affine, 0, g.xx);
    set_field<Real>(affine, 1, g.xy);
    set_field<Real>(affine, 2, g.yx);
    set_field<Real>(affine, 3, g.yy);
  } else {
    constexpr int n = nodes_of<stencil>;
    Pack<Real> along_x[n], along_y[n];
    const Pack<Real> at_x = field(record, Field::xi);
    const Pack<Real> at_y = field(record, Field::eta);
    // Folded weights have no variance at the support; those of the nodes beyond it, which follow a line, do.
    const auto free_x = weights<Real, stencil>(at_x, step.half_size);
    const auto free_y = weights<Real, stencil>(at_y, step.half_size);
    const Pack<Real> per_dx = (1 / step.hx) / variance<Real, n>(free_x, at_x);
    const Pack<Real> per_dy = (1 / step.hy) / variance<Real, n>(free_y, at_y);
    unrolled<n>([&](auto i) MPM_INLINE_LAMBDA {
      along_x[i.value] = free_x.w[i.value] * (Real(node_place<stencil>(i.value)) - at_x) * per_dx;
      along_y[i.value] = free_y.w[i.value] * (Real(node_place<stencil>(i.value)) - at_y) * per_dy;
    });
    fold_across<Real>(along_x, folds);
    fold_upwards<Real>(along_y, folds);
    set_field<Real>(affine, 0, weighted<Real>(nodes_x, along_x, y.w));
    set_field<Real>(affine, 1, weighted<Real>(nodes_x, x.w, along_y));
    set_field<Real>(affine, 2, weighted<Real>(nodes_y, along_x, y.w));
    set_field<Real>(affine, 3, weighted<Real>(nodes_y, x.w, along_y));
  }
}

template <class Real, Stencil stencil, Return transfer, bool maps_back>
Real gather(const TileRow<Real>& in, const Step<Real>& of_step, NodeVectors<Real> change,
            NodeVectors<Real> fresh, Sums<Real> momentum) {
  constexpr int n = nodes_of<stencil>;
  constexpr bool needs_change = transfer != Return::apic || stencil == Stencil::linear;
  constexpr bool needs_fresh = transfer != Return::flip;
  const TileRow<Real> row = in;
  const Step<Real> step = of_step;
  const Real ratio = step.flip_ratio;
  Pack<Real> fastest{};
  for (int block = 0; block < row.blocks; ++block) {
    if (!maps_back && row.used[block] == 0) continue;
    const int tile = block * lanes<Real>;
    TileNodes<Real, n> change_x{}, change_y{}, fresh_x{}, fresh_y{};
    if constexpr (needs_change) {
      change_x = load_nodes<Real, n>(change.x, change.stride, tile);
      change_y = load_nodes<Real, n>(change.y, change.stride, tile);
    }
    if constexpr (needs_fresh) {
      fresh_x = load_nodes<Real, n>(fresh.x, fresh.stride, tile);
      fresh_y = load_nodes<Real, n>(fresh.y, fresh.stride, tile);
    }
    TileTotals<Real, n, 2> momenta;
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      const auto x = weights_across<Real, stencil>(record, step.half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, step.half_size, folds);
      Pack<Real> v_x{}, v_y{};
      if constexpr (transfer != Return::apic) {
        v_x = field<Real>(record, Field::vx) + interpolated<Real>(change_x, x, y);
        v_y = field<Real>(record, Field::vy) + interpolated<Real>(change_y, x, y);
      }
      if constexpr (transfer == Return::blend) {
        v_x = ratio * v_x + (1 - ratio) * interpolated<Real>(fresh_x, x, y);
        v_y = ratio * v_y + (1 - ratio) * interpolated<Real>(fresh_y, x, y);
      }
      if constexpr (transfer == Return::apic) {
        v_x = interpolated<Real>(fresh_x, x, y);
        v_y = interpolated<Real>(fresh_y, x, y);
        if constexpr (stencil == Stencil::linear)
          gather_affine<Real, stencil>(row, record, step, change_x, change_y, x, y, folds);
        else
          gather_affine<Real, stencil>(row, record, step, fresh_x, fresh_y, x, y, folds);
      }
      const Mask<Real> there = field<Real>(record, Field::mass) > Pack<Real>{};
      v_x = there ? v_x : Pack<Real>{};
      v_y = there ? v_y : Pack<Real>{};
      set_field<Real>(record, Field::vx, v_x);
      set_field<Real>(record, Field::vy, v_y);
      const Pack<Real> square = v_x * v_x + v_y * v_y;
      fastest = square > fastest ? square : fastest;
      if constexpr (maps_back)
        add_momentum<Real, stencil, 2, transfer == Return::apic>(momenta, row, record, step, x, y);
    }
    if constexpr (maps_back) momenta.store_in(momentum, tile);
  }
  Real result = 0;
  for (int i = 0; i < lanes<Real>; ++i) result = fastest[i] > result ? fastest[i] : result;
  return result;
}

}  // namespace
}  // namespace mpm::moving
