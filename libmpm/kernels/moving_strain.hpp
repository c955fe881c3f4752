/// Effect of the motion of the nodes on moving points: stress, volume and position. Private to
/// moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_stress.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

/// Volume and stress at the end of the step.
template <class Real>
MPM_INLINE Stress<Pack<Real>> strained(Real* record, const Gradient<Real>& g) {
  const Strained<Real> result = turned_and_loaded<Real>(
      stress_of<Real>(record), g, field<Real>(record, Field::lame), field<Real>(record, Field::shear));
  set_field<Real>(record, Field::volume, field<Real>(record, Field::volume) * result.growth);
  set_field<Real>(record, Field::sxx, result.stress.xx);
  set_field<Real>(record, Field::syy, result.stress.yy);
  set_field<Real>(record, Field::sxy, result.stress.xy);
  return result.stress;
}

/// Position at the end of the step. @return the lanes whose point is still in its tile.
template <class Real, int N>
MPM_INLINE Mask<Real> moved(const TileRow<Real>& row, Real* record, const Step<Real>& step,
                            const TileNodes<Real, N>& vx, const TileNodes<Real, N>& vy,
                            const Weights<Real, N>& x, const Weights<Real, N>& y) {
  const Pack<Real> zero{};
  const Pack<Real> one = all<Real>(1);
  const Pack<Real> middle = all<Real>(0.5);
  const Real per_x = step.dt / step.hx;
  const Real per_y = step.dt / step.hy_after;
  const Pack<Real> old_x = field<Real>(record, Field::xi);
  const Pack<Real> old_y = field<Real>(record, Field::eta);
  const Mask<Real> there = field<Real>(record, Field::mass) > zero;
  const Pack<Real> moved_x = old_x + per_x * interpolated<Real>(vx, x, y);
  const Pack<Real> moved_y =
      old_y + (step.shrinkage * (row.bottom + old_y) + per_y * interpolated<Real>(vy, x, y));
  const Pack<Real> new_x = there ? moved_x : middle;
  const Pack<Real> new_y = there ? moved_y : middle;
  set_field<Real>(record, Field::xi, new_x);
  set_field<Real>(record, Field::eta, new_y);
  return (new_x >= zero) & (new_x < one) & (new_y >= zero) & (new_y < one);
}

enum class Followed { stress, place, both };

template <class Real, Stencil stencil, Followed what, kernels::Check check, bool closure>
int follow(const TileRow<Real>& in, const Step<Real>& of_step, NodeVectors<Real> straining,
           NodeVectors<Real> fresh, std::uint8_t* flags) {
  constexpr int n = nodes_of<stencil>;
  constexpr bool strains = what != Followed::place;
  constexpr bool moves = what != Followed::stress;
  const TileRow<Real> row = in;
  const Step<Real> step = of_step;
  const Real per_x = step.dt / step.hx;
  const Real per_y = step.dt / step.hy;
  int any = 0;
  for (int block = 0; block < row.blocks; ++block) {
    flags[block] = 0;
    if (row.used[block] == 0) continue;
    const int tile = block * lanes<Real>;
    TileNodes<Real, n> strain_x{}, strain_y{}, fresh_x{}, fresh_y{};
    if constexpr (strains) {
      strain_x = load_nodes<Real, n>(straining.x, straining.stride, tile);
      strain_y = load_nodes<Real, n>(straining.y, straining.stride, tile);
    }
    if constexpr (moves) {
      fresh_x = load_nodes<Real, n>(fresh.x, fresh.stride, tile);
      fresh_y = load_nodes<Real, n>(fresh.y, fresh.stride, tile);
    }
    Mask<Real> suspect{};
    Mask<Real> stays = ~Mask<Real>{};
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      const auto x = weights_across<Real, stencil>(record, step.half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, step.half_size, folds);
      if constexpr (strains) {
        const Stress<Pack<Real>> s =
            strained<Real>(record, gradient<Real>(strain_x, strain_y, x, y, per_x, per_y));
        if constexpr (check != kernels::Check::none)
          suspect |= suspect_lanes<check, Real>(carried<Real, closure>(s, row, record, step.unilateral), row,
                                                record);
      }
      if constexpr (moves) stays &= moved<Real, n>(row, record, step, fresh_x, fresh_y, x, y);
    }
    int flag = 0;
    if constexpr (check != kernels::Check::none) flag |= any_of<Real>(suspect) ? may_fail : 0;
    if constexpr (moves) flag |= any_of<Real>(~stays) ? has_left : 0;
    flags[block] = static_cast<std::uint8_t>(flag);
    any |= flag;
  }
  return any;
}

template <class Real, Stencil stencil>
void deform(const TileRow<Real>& in, const Step<Real>& of_step, NodeVectors<Real> straining) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Step<Real> step = of_step;
  for (int block = 0; block < row.blocks; ++block) {
    if (row.used[block] == 0) continue;
    const auto vx = load_nodes<Real, n>(straining.x, straining.stride, block * lanes<Real>);
    const auto vy = load_nodes<Real, n>(straining.y, straining.stride, block * lanes<Real>);
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      const auto x = weights_across<Real, stencil>(record, step.half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, step.half_size, folds);
      const Gradient<Real> g = gradient<Real>(vx, vy, x, y, step.dt / step.hx, step.dt / step.hy);
      Real* f = record + row.layout.deformation * lanes<Real>;
      const Pack<Real> xx = field<Real>(f, 0);
      const Pack<Real> xy = field<Real>(f, 1);
      const Pack<Real> yx = field<Real>(f, 2);
      const Pack<Real> yy = field<Real>(f, 3);
      set_field<Real>(f, 0, xx + g.xx * xx + g.xy * yx);
      set_field<Real>(f, 1, xy + g.xx * xy + g.xy * yy);
      set_field<Real>(f, 2, yx + g.yx * xx + g.yy * yx);
      set_field<Real>(f, 3, yy + g.yx * xy + g.yy * yy);
    }
  }
}

}  // namespace
}  // namespace mpm::moving
