/// Rows of nodes: the sums from the tiles, and the step of the nodes. Private to moving_kernels.cpp.
#pragma once

#include "libmpm/kernels/moving_weights.hpp"

namespace mpm::moving {
namespace {  // a copy for each instruction set

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

/// One over the mass of nodes that take part, 0 for the others.
template <class Real>
MPM_INLINE Pack<Real> per_mass(const Pack<Real>& m, const Pack<Real>& least) {
  const Mask<Real> heavy = m > least;
  return heavy ? 1 / (heavy ? m : least) : Pack<Real>{};
}

template <class Real, Stencil stencil>
void sum_momentum(const NodeRow<Real>& in, Real least_mass, Real* mass, Real* vx, Real* vy) {
  constexpr int n = nodes_of<stencil>;
  const NodeRow<Real> row = in;
  const Pack<Real> least = all<Real>(least_mass);
  for (int i = 0; i < row.nodes; i += lanes<Real>) {
    const Pack<Real> m = node_sum<Real, n, 3, 0>(row, i);
    const Pack<Real> per_m = per_mass<Real>(m, least);
    store<Real>(mass + i, m);
    store<Real>(vx + i, per_m * node_sum<Real, n, 3, 1>(row, i));
    store<Real>(vy + i, per_m * node_sum<Real, n, 3, 2>(row, i));
  }
}

template <class Real, Stencil stencil>
void sum_new_momentum(const NodeRow<Real>& in, Real least_mass, const Real* mass, Real* vx, Real* vy) {
  constexpr int n = nodes_of<stencil>;
  const NodeRow<Real> row = in;
  const Pack<Real> least = all<Real>(least_mass);
  for (int i = 0; i < row.nodes; i += lanes<Real>) {
    const Pack<Real> per_m = per_mass<Real>(load<Real>(mass + i), least);
    store<Real>(vx + i, per_m * node_sum<Real, n, 2, 0>(row, i));
    store<Real>(vy + i, per_m * node_sum<Real, n, 2, 1>(row, i));
  }
}

/// Damping force, opposed to the motion. Source: local damping, Cundall (1987).
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
    const Pack<Real> impulse = nodes.dt * per_mass<Real>(m, least);
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

}  // namespace
}  // namespace mpm::moving
