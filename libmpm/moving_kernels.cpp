// Compiled once per instruction set, with MPM_KERNELS naming the table that it defines. Everything here but
// that table is local to the file, and what comes in from outside is always inlined: no code for a newer
// processor can leak into the rest.
#include "libmpm/moving_kernels.hpp"

#include "libmpm/moving_stress.hpp"
#include "libmpm/moving_weights.hpp"

namespace mpm::moving {
namespace {

template <class Real, Stencil stencil, bool affine>
void scatter_momentum(const TileRow<Real>& in, const Step<Real>& step, Sums<Real> out) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  const Real hx = step.hx;
  const Real hy = step.hy;
  for (int block = 0; block < row.blocks; ++block) {
    Pack<Real> sums[n * n * 3] = {};
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      const Real* record = record_of(row, block, slot);
      fetch_ahead<Real, Field::xi, Field::mass>(row, record);
      const Pack<Real> at_x = field(record, Field::xi);
      const Pack<Real> at_y = field(record, Field::eta);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      const Pack<Real> m = field(record, Field::mass);
      const Pack<Real> v_x = field(record, Field::vx);
      const Pack<Real> v_y = field(record, Field::vy);
      Pack<Real> c_xx{}, c_xy{}, c_yx{}, c_yy{};
      if constexpr (affine) {
        c_xx = hx * field(record, row.layout.affine);
        c_xy = hy * field(record, row.layout.affine + 1);
        c_yx = hx * field(record, row.layout.affine + 2);
        c_yy = hy * field(record, row.layout.affine + 3);
      }
      unrolled<n>([&](auto b) MPM_INLINE_LAMBDA {
        const Pack<Real> m_row = m * y.w[b.value];
        const Pack<Real> dy = Real(node_place<stencil>(b.value)) - at_y;
        unrolled<n>([&](auto a) MPM_INLINE_LAMBDA {
          constexpr int plane = (b.value * n + a.value) * 3;
          const Pack<Real> m_node = m_row * x.w[a.value];
          sums[plane] += m_node;
          if constexpr (affine) {
            const Pack<Real> dx = Real(node_place<stencil>(a.value)) - at_x;
            sums[plane + 1] += m_node * (v_x + c_xx * dx + c_xy * dy);
            sums[plane + 2] += m_node * (v_y + c_yx * dx + c_yy * dy);
          } else {
            sums[plane + 1] += m_node * v_x;
            sums[plane + 2] += m_node * v_y;
          }
        });
      });
    }
    store_sums<Real, n, 3>(out, block * lanes<Real>, sums);
  }
}

template <class Real, Stencil stencil, bool closure>
void scatter_force(const TileRow<Real>& in, const Step<Real>& step, Sums<Real> out) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  const Real per_hx = 1 / step.hx;
  const Real per_hy = 1 / step.hy;
  const Real unilateral = step.unilateral;
  for (int block = 0; block < row.blocks; ++block) {
    Pack<Real> sums[n * n * 2] = {};
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      const Real* record = record_of(row, block, slot);
      fetch_ahead<Real, Field::volume, Field::sxy>(row, record);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      const Stress<Pack<Real>> s = carried<Real, closure>(stress_of<Real>(record), row, record, unilateral);
      const Pack<Real> minus_v = -field(record, Field::volume);
      const Pack<Real> v_x = minus_v * per_hx;
      const Pack<Real> v_y = minus_v * per_hy;
      const Pack<Real> xx = v_x * s.xx;
      const Pack<Real> xy_y = v_y * s.xy;
      const Pack<Real> xy_x = v_x * s.xy;
      const Pack<Real> yy = v_y * s.yy;
      // f = -V s . grad(S)
      unrolled<n>([&](auto b) MPM_INLINE_LAMBDA {
        const Pack<Real> fx_dx = xx * y.w[b.value];
        const Pack<Real> fx_w = xy_y * y.dw[b.value];
        const Pack<Real> fy_dx = xy_x * y.w[b.value];
        const Pack<Real> fy_w = yy * y.dw[b.value];
        unrolled<n>([&](auto a) MPM_INLINE_LAMBDA {
          constexpr int plane = (b.value * n + a.value) * 2;
          sums[plane] += fx_dx * x.dw[a.value] + fx_w * x.w[a.value];
          sums[plane + 1] += fy_dx * x.dw[a.value] + fy_w * x.w[a.value];
        });
      });
    }
    store_sums<Real, n, 2>(out, block * lanes<Real>, sums);
  }
}

/// B over the variance of the weights, for linear shapes the sum of gradient by velocity: the gradient of the
/// velocity [1/s].
template <class Real, Stencil stencil>
MPM_INLINE void gather_affine(const TileRow<Real>& row, Real* record, const Step<Real>& step,
                              const TileNodes<Real, nodes_of<stencil>>& nodes_x,
                              const TileNodes<Real, nodes_of<stencil>>& nodes_y,
                              const Weights<Real, nodes_of<stencil>>& x,
                              const Weights<Real, nodes_of<stencil>>& y, const BlockFolds<Real>& folds) {
  constexpr int n = nodes_of<stencil>;
  Pack<Real> along_x[n], along_y[n];
  if constexpr (stencil == Stencil::linear) {
    unrolled<n>([&](auto i) MPM_INLINE_LAMBDA {
      along_x[i.value] = x.dw[i.value] * (1 / step.hx);
      along_y[i.value] = y.dw[i.value] * (1 / step.hy);
    });
  } else {
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
  }
  set_field<Real>(record, row.layout.affine, interpolated<Real, n>(nodes_x, along_x, y.w));
  set_field<Real>(record, row.layout.affine + 1, interpolated<Real, n>(nodes_x, x.w, along_y));
  set_field<Real>(record, row.layout.affine + 2, interpolated<Real, n>(nodes_y, along_x, y.w));
  set_field<Real>(record, row.layout.affine + 3, interpolated<Real, n>(nodes_y, x.w, along_y));
}

template <class Real, Stencil stencil, Return transfer>
Real gather_velocity(const TileRow<Real>& in, const Step<Real>& step, NodeVectors<Real> change,
                     NodeVectors<Real> fresh) {
  constexpr int n = nodes_of<stencil>;
  constexpr bool needs_change = transfer != Return::apic || stencil == Stencil::linear;
  constexpr bool needs_fresh = transfer != Return::flip;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  const Real ratio = step.flip_ratio;
  Pack<Real> fastest{};
  for (int block = 0; block < row.blocks; ++block) {
    if (row.used[block] == 0) continue;
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
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      fetch_ahead<Real, Field::xi, Field::mass>(row, record);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      Pack<Real> v_x{}, v_y{};
      if constexpr (transfer != Return::apic) {
        v_x = field<Real>(record, Field::vx) + interpolated<Real, n>(change_x, x.w, y.w);
        v_y = field<Real>(record, Field::vy) + interpolated<Real, n>(change_y, x.w, y.w);
      }
      if constexpr (transfer == Return::blend) {
        v_x = ratio * v_x + (1 - ratio) * interpolated<Real, n>(fresh_x, x.w, y.w);
        v_y = ratio * v_y + (1 - ratio) * interpolated<Real, n>(fresh_y, x.w, y.w);
      }
      if constexpr (transfer == Return::apic) {
        v_x = interpolated<Real, n>(fresh_x, x.w, y.w);
        v_y = interpolated<Real, n>(fresh_y, x.w, y.w);
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
    }
  }
  Real result = 0;
  for (int i = 0; i < lanes<Real>; ++i) result = fastest[i] > result ? fastest[i] : result;
  return result;
}

template <class Real, Stencil stencil, kernels::Check check, bool closure>
int update_stress(const TileRow<Real>& in, const Step<Real>& step, NodeVectors<Real> velocity,
                  std::uint8_t* suspects) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  const Real per_x = step.dt / step.hx;
  const Real per_y = step.dt / step.hy;
  const Real unilateral = step.unilateral;
  int any = 0;
  for (int block = 0; block < row.blocks; ++block) {
    suspects[block] = 0;
    if (row.used[block] == 0) continue;
    const auto vx = load_nodes<Real, n>(velocity.x, velocity.stride, block * lanes<Real>);
    const auto vy = load_nodes<Real, n>(velocity.y, velocity.stride, block * lanes<Real>);
    Mask<Real> suspect{};
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      fetch_ahead<Real, Field::xi, Field::basic_fields + 1>(row, record);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      const Gradient<Real> g = gradient<Real, n>(vx, vy, x, y, per_x, per_y);
      const Pack<Real> v = field<Real>(record, Field::volume);
      set_field<Real>(record, Field::volume, v * ((1 + g.xx) * (1 + g.yy) - g.xy * g.yx));
      const Stress<Pack<Real>> s = turned_and_loaded<Real>(
          stress_of<Real>(record), g, field<Real>(record, Field::lame), field<Real>(record, Field::shear));
      set_field<Real>(record, Field::sxx, s.xx);
      set_field<Real>(record, Field::syy, s.yy);
      set_field<Real>(record, Field::sxy, s.xy);
      if constexpr (check != kernels::Check::none)
        suspect |=
            suspect_lanes<check, Real>(carried<Real, closure>(s, row, record, unilateral), row, record);
    }
    if constexpr (check != kernels::Check::none) {
      suspects[block] = any_of<Real>(suspect) ? 1 : 0;
      any |= suspects[block];
    }
  }
  return any;
}

template <class Real, Stencil stencil>
int move_points(const TileRow<Real>& in, const Step<Real>& step, NodeVectors<Real> fresh,
                std::uint8_t* left) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  const Real per_x = step.dt / step.hx;
  const Real per_y = step.dt / step.hy_after;
  const Real shrinkage = step.shrinkage;
  const Pack<Real> zero{};
  const Pack<Real> one = all<Real>(1);
  const Pack<Real> middle = all<Real>(0.5);
  int any = 0;
  for (int block = 0; block < row.blocks; ++block) {
    left[block] = 0;
    if (row.used[block] == 0) continue;
    const auto vx = load_nodes<Real, n>(fresh.x, fresh.stride, block * lanes<Real>);
    const auto vy = load_nodes<Real, n>(fresh.y, fresh.stride, block * lanes<Real>);
    Mask<Real> stays = ~Mask<Real>{};
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      const Pack<Real> old_x = field<Real>(record, Field::xi);
      const Pack<Real> old_y = field<Real>(record, Field::eta);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      const Mask<Real> there = field<Real>(record, Field::mass) > zero;
      const Pack<Real> moved_x = old_x + per_x * interpolated<Real, n>(vx, x.w, y.w);
      const Pack<Real> moved_y =
          old_y + (shrinkage * (row.bottom + old_y) + per_y * interpolated<Real, n>(vy, x.w, y.w));
      const Pack<Real> new_x = there ? moved_x : middle;
      const Pack<Real> new_y = there ? moved_y : middle;
      set_field<Real>(record, Field::xi, new_x);
      set_field<Real>(record, Field::eta, new_y);
      stays &= (new_x >= zero) & (new_x < one) & (new_y >= zero) & (new_y < one);
    }
    left[block] = any_of<Real>(~stays) ? 1 : 0;
    any |= left[block];
  }
  return any;
}

template <class Real, Stencil stencil>
void deform(const TileRow<Real>& in, const Step<Real>& step, NodeVectors<Real> velocity) {
  constexpr int n = nodes_of<stencil>;
  const TileRow<Real> row = in;
  const Real half_size = step.half_size;
  for (int block = 0; block < row.blocks; ++block) {
    if (row.used[block] == 0) continue;
    const auto vx = load_nodes<Real, n>(velocity.x, velocity.stride, block * lanes<Real>);
    const auto vy = load_nodes<Real, n>(velocity.y, velocity.stride, block * lanes<Real>);
    const BlockFolds<Real> folds = folds_of<Real, stencil>(row, block);
    for (int slot = 0; slot < row.used[block]; ++slot) {
      Real* record = record_of(row, block, slot);
      const auto x = weights_across<Real, stencil>(record, half_size, folds);
      const auto y = weights_upwards<Real, stencil>(record, half_size, folds);
      const Gradient<Real> g = gradient<Real, n>(vx, vy, x, y, step.dt / step.hx, step.dt / step.hy);
      const Pack<Real> xx = field<Real>(record, row.layout.deformation);
      const Pack<Real> xy = field<Real>(record, row.layout.deformation + 1);
      const Pack<Real> yx = field<Real>(record, row.layout.deformation + 2);
      const Pack<Real> yy = field<Real>(record, row.layout.deformation + 3);
      set_field<Real>(record, row.layout.deformation, xx + g.xx * xx + g.xy * yx);
      set_field<Real>(record, row.layout.deformation + 1, xy + g.xx * xy + g.xy * yy);
      set_field<Real>(record, row.layout.deformation + 2, yx + g.yx * xx + g.yy * yx);
      set_field<Real>(record, row.layout.deformation + 3, yy + g.yx * xy + g.yy * yy);
    }
  }
}

template <class Real>
MPM_INLINE double sum_of(const Pack<Real>& pack) {
  double sum = 0;
  for (int i = 0; i < lanes<Real>; ++i) sum += static_cast<double>(pack[i]);
  return sum;
}

/// Kinetic energy, and the elastic energy 1/2 V s : e with e of the stress that an intact point would carry.
template <class Real, bool closure>
Energies measure_energies(const TileRow<Real>& in, const Step<Real>& step) {
  const TileRow<Real> row = in;
  const Pack<Real> zero{};
  Energies sum;
  for (int block = 0; block < row.blocks; ++block) {
    for (int slot = 0; slot < row.used[block]; ++slot) {
      const Real* record = record_of(row, block, slot);
      const Pack<Real> v_x = field(record, Field::vx);
      const Pack<Real> v_y = field(record, Field::vy);
      sum.kinetic += sum_of<Real>(Real(0.5) * field(record, Field::mass) * (v_x * v_x + v_y * v_y));
      const Stress<Pack<Real>> e = stress_of<Real>(record);
      const Stress<Pack<Real>> s = carried<Real, closure>(e, row, record, step.unilateral);
      const Pack<Real> lame = field(record, Field::lame);
      const Pack<Real> shear = field(record, Field::shear);
      const Mask<Real> carries = shear > zero;
      const Pack<Real> g = carries ? shear : all<Real>(1);
      const Pack<Real> product = s.xx * e.xx + s.yy * e.yy + 2 * s.xy * e.xy;
      const Pack<Real> traces = (s.xx + s.yy) * (e.xx + e.yy);
      const Pack<Real> energy =
          Real(0.25) * field(record, Field::volume) * (product - Real(0.5) * lame / (lame + g) * traces) / g;
      sum.elastic += sum_of<Real>(carries ? energy : zero);
    }
  }
  return sum;
}

/// Sum of quantity f of n at node i over the tiles that hold it.
template <class Real, int n, int quantities, int f>
MPM_INLINE Pack<Real> node_sum(const NodeRow<Real>& row, int i) {
  Pack<Real> sum{};
  unrolled<n>([&](auto b) MPM_INLINE_LAMBDA {
    unrolled<n>([&](auto a) MPM_INLINE_LAMBDA {
      constexpr int plane = (b.value * n + a.value) * quantities + f;
      sum += load<Real>(row.tiles[b.value] + plane * row.length + i - a.value);
    });
  });
  return sum;
}

template <class Real, Stencil stencil>
void sum_momentum(const NodeRow<Real>& in, Real least_mass, Real* mass, Real* vx, Real* vy) {
  constexpr int n = nodes_of<stencil>;
  const NodeRow<Real> row = in;
  const Pack<Real> least = all<Real>(least_mass);
  for (int i = 0; i < row.nodes; i += lanes<Real>) {
    const Pack<Real> m = node_sum<Real, n, 3, 0>(row, i);
    const Mask<Real> heavy = m > least;
    const Pack<Real> per_m = heavy ? 1 / (heavy ? m : least) : Pack<Real>{};
    store<Real>(mass + i, m);
    store<Real>(vx + i, per_m * node_sum<Real, n, 3, 1>(row, i));
    store<Real>(vy + i, per_m * node_sum<Real, n, 3, 2>(row, i));
  }
}

/// The force less the damping that opposes the motion. Source: local damping, Cundall (1987).
template <class Real>
MPM_INLINE Pack<Real> damping_force(const Pack<Real>& f, const Pack<Real>& v, Real damping) {
  const Pack<Real> zero{};
  const Pack<Real> size = damping * (f < zero ? -f : f);
  return v > zero ? -size : (v < zero ? size : zero);
}

template <class Real, Stencil stencil, bool damped>
double integrate(const Integration<Real>& in) {
  constexpr int n = nodes_of<stencil>;
  const Integration<Real> nodes = in;
  const Pack<Real> least = all<Real>(nodes.least_mass);
  const Pack<Real> light = all<Real>(nodes.light_mass);
  const Real per_light = nodes.light_mass > 0 ? 1 / nodes.light_mass : Real(1);
  Pack<Real> taken{};
  for (int i = 0; i < nodes.forces.nodes; i += lanes<Real>) {
    const Pack<Real> m = load<Real>(nodes.mass + i);
    const Mask<Real> heavy = m > least;
    const Pack<Real> impulse = heavy ? nodes.dt / (heavy ? m : least) : Pack<Real>{};
    const Pack<Real> v_x = load<Real>(nodes.vx + i);
    const Pack<Real> v_y = load<Real>(nodes.vy + i);
    Pack<Real> fx = node_sum<Real, n, 2, 0>(nodes.forces, i);
    Pack<Real> fy = node_sum<Real, n, 2, 1>(nodes.forces, i);
    Pack<Real> drag_x{}, drag_y{};
    if constexpr (damped) {
      drag_x = damping_force<Real>(fx, v_x, nodes.damping);
      drag_y = damping_force<Real>(fy, v_y, nodes.damping);
      fx += drag_x;
      fy += drag_y;
    }
    const Pack<Real> change_x = impulse * fx;
    const Pack<Real> change_y = impulse * fy;
    store<Real>(nodes.change_x + i, change_x);
    store<Real>(nodes.change_y + i, change_y);
    store<Real>(nodes.fresh_x + i, v_x + change_x);
    store<Real>(nodes.fresh_y + i, v_y + change_y);
    if constexpr (damped) {
      const Pack<Real> half = Real(0.5) * (m < light ? m * per_light : all<Real>(1));
      taken -= drag_x * (v_x + half * change_x) + drag_y * (v_y + half * change_y);
    }
  }
  return sum_of<Real>(taken) * static_cast<double>(nodes.dt);
}

template <class Real, Stencil stencil>
UpdateStress<Real> update_stress_for(const Features& f) {
  using kernels::Check;
  if (f.crack_closure) return update_stress<Real, stencil, Check::tension_and_shear, true>;
  switch (f.check) {
    case Check::none:
      return update_stress<Real, stencil, Check::none, false>;
    case Check::tension:
      return update_stress<Real, stencil, Check::tension, false>;
    case Check::tension_and_shear:
      break;
  }
  return update_stress<Real, stencil, Check::tension_and_shear, false>;
}

template <class Real, Stencil stencil>
GatherVelocity<Real> gather_velocity_for(const Features& f) {
  switch (f.transfer) {
    case Return::flip:
      return gather_velocity<Real, stencil, Return::flip>;
    case Return::blend:
      return gather_velocity<Real, stencil, Return::blend>;
    case Return::apic:
      break;
  }
  return gather_velocity<Real, stencil, Return::apic>;
}

template <class Real, Stencil stencil>
Sweeps<Real> sweeps_of(const Features& f) {
  return {lanes<Real>,
          f.transfer == Return::apic ? scatter_momentum<Real, stencil, true>
                                     : scatter_momentum<Real, stencil, false>,
          f.crack_closure ? scatter_force<Real, stencil, true> : scatter_force<Real, stencil, false>,
          gather_velocity_for<Real, stencil>(f),
          update_stress_for<Real, stencil>(f),
          move_points<Real, stencil>,
          deform<Real, stencil>,
          f.crack_closure ? measure_energies<Real, true> : measure_energies<Real, false>,
          sum_momentum<Real, stencil>,
          f.damping ? integrate<Real, stencil, true> : integrate<Real, stencil, false>};
}

template <class Real>
Sweeps<Real> sweeps(const Features& f) {
  return f.stencil == Stencil::linear ? sweeps_of<Real, Stencil::linear>(f)
                                      : sweeps_of<Real, Stencil::quadratic>(f);
}

}  // namespace

#define MPM_TEXT_OF(name) #name
#define MPM_TEXT(name) MPM_TEXT_OF(name)
extern const Kernels MPM_KERNELS = {MPM_TEXT(MPM_KERNELS), sweeps<float>, sweeps<double>};

}  // namespace mpm::moving
