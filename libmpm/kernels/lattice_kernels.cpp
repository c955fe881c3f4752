// Compiled once per instruction set, with MPM_KERNELS naming the table that it defines. Everything here but
// that table is local to the file, and nothing inline comes in from outside: no code for a newer processor
// can leak into the rest.
#include "libmpm/kernels/lattice_kernels.hpp"

#include "libmpm/kernels/unroll.hpp"
#include "libmpm/material/stress.hpp"

namespace mpm::kernels {
namespace {

/// What the points of a cell need of its four nodes: differences along its edges, as strain times cell size.
/// ends[0] is the lower or left edge, ends[1] the upper or right one.
template <class Real>
struct EdgeStrains {
  Real x_of_ux[2], x_of_uy[2], y_of_ux[2], y_of_uy[2];
};

template <class Real, class Node>
MPM_INLINE EdgeStrains<Real> edge_strains(const CellRow<Real, Node>& row, int i) {
  const Node *ux0 = row.ux_lower, *uy0 = row.uy_lower, *ux1 = row.ux_upper, *uy1 = row.uy_upper;
  // Differences are taken in the precision of the nodes: displacements grow, the strains in one cell stay
  // small.
  return {{Real(ux0[i + 1] - ux0[i]), Real(ux1[i + 1] - ux1[i])},
          {Real(uy0[i + 1] - uy0[i]), Real(uy1[i + 1] - uy1[i])},
          {Real(ux1[i] - ux0[i]), Real(ux1[i + 1] - ux0[i + 1])},
          {Real(uy1[i] - uy0[i]), Real(uy1[i + 1] - uy0[i + 1])}};
}

/// Linear interpolation between two edges at point `p` of K.
template <int K, int P, class Real>
MPM_INLINE Real between(const Real (&edge)[2]) {
  constexpr Real far = (Real(P) + Real(0.5)) / Real(K);
  return (1 - far) * edge[0] + far * edge[1];
}

/// The smaller of two; the second if either is not a number.
template <class Real>
MPM_INLINE Real smaller(Real a, Real b) {
  return a < b ? a : b;
}

/// Not 0 when a point may fail: s1 > T or s3 < -S, without a square root. Both principal stresses lie below T
/// exactly when T I - s is positive definite: its determinant and one of its diagonal are above 0.
/// Not-a-number is suspect: it is in the determinant, wherever it comes from.
template <Check check, class Real, class Node>
MPM_INLINE Flag<Real> is_suspect(const Stress<Real>& s, const CellRow<Real, Node>& row, std::ptrdiff_t at) {
  if constexpr (check == Check::none) return 0;
  const Real tension = Real(row.tension[at]);
  const Real square = s.xy * s.xy;
  const Real reserve = tension - s.xx;
  Real least = smaller(reserve, reserve * (tension - s.yy) - square);
  if constexpr (check == Check::tension_and_shear) {
    const Real crush = Real(row.crush[at]);
    const Real depth = crush + s.xx;
    least = smaller(least, smaller(depth, depth * (crush + s.yy) - square));
  }
  return least > 0 ? 0 : 1;
}

/// Sums over the points of a cell, by row b (of stress along x) and by column a (of stress along y).
template <class Real, int K>
struct CellSums {
  Real xx[K], yy[K], xy_row[K], xy_col[K];
};

/// Lateral stress ratio of a point; a dead one has no stiffness and no stress to share out.
template <class Real>
MPM_INLINE Real lateral_ratio(Real lame, Real shear) {
  const Real axial = lame + 2 * shear;
  return lame / (axial > 0 ? axial : Real(1));
}

/// Stress of a point for its strains: with one Poisson ratio that of a phase with E = 1.
template <class Real, bool one_poisson, bool closure, class Node>
MPM_INLINE Stress<Real> point_stress(const CellRow<Real, Node>& row, Real exx, Real eyy, Real gxy,
                                     std::ptrdiff_t at) {
  Stress<Real> s;
  if constexpr (one_poisson) {
    s = {row.unit_axial * exx + row.unit_lateral * eyy, row.unit_lateral * exx + row.unit_axial * eyy,
         row.unit_shear * gxy};
  } else {
    s = elastic_stress<Real>(row.stiffness[at], row.shear[at], exx, eyy, gxy);
  }
  if constexpr (closure) {
    const Real lateral = row.unilateral * (one_poisson ? row.unit_lateral / row.unit_axial
                                                       : lateral_ratio(row.stiffness[at], row.shear[at]));
    const Stress<Real> c = without_tension(s, lateral);
    const Real cracked = Real(row.cracked[at]);
    const Real whole = 1 - cracked;
    s = {whole * s.xx + cracked * c.xx, whole * s.yy + cracked * c.yy, whole * s.xy + cracked * c.xy};
  }
  return s;
}

/// Stress of point p, already times its stiffness and volume share, added to the sums; returns suspicion.
template <class Real, int K, int P, bool one_poisson, Check check, bool closure, class Node>
MPM_INLINE Flag<Real> add_point(const CellRow<Real, Node>& row, const EdgeStrains<Real>& edges, int i,
                                CellSums<Real, K>& sums) {
  constexpr int a = P % K;
  constexpr int b = P / K;
  const std::ptrdiff_t at = P * row.stride + i;
  const Real exx = between<K, b>(edges.x_of_ux);
  const Real eyy = between<K, a>(edges.y_of_uy);
  const Real gxy = between<K, a>(edges.y_of_ux) + between<K, b>(edges.x_of_uy);
  const Stress<Real> s = point_stress<Real, one_poisson, closure>(row, exx, eyy, gxy, at);
  const Flag<Real> suspect = is_suspect<check>(s, row, at);

  const Real weight = one_poisson ? row.stiffness[at] : Real(1);
  sums.xx[b] += weight * s.xx;
  sums.yy[a] += weight * s.yy;
  const Real weighted_xy = weight * s.xy;
  sums.xy_row[b] += weighted_xy;
  sums.xy_col[a] += weighted_xy;
  return suspect;
}

/// Stiffness of a pixel cell against bending, per unit of the difference of the strains of its edges. With it
/// a square cell bends as a beam does, and does not lock when the material is nearly incompressible.
/// Source: Belytschko, Bindeman, Comput. Methods Appl. Mech. Eng. 88 (1991), ASQBI: E / 12 in plane stress,
/// E / (1 - nu^2) / 12 in plane strain.
template <class Real, bool one_poisson, bool closure, class Node>
MPM_INLINE Real bending_stiffness(const CellRow<Real, Node>& row, int i) {
  Real k;
  if constexpr (one_poisson) {
    k = row.stiffness[i] * row.unit_bending;
  } else {
    const Real lame = row.stiffness[i];
    const Real shear = row.shear[i];
    const Real ratio = lateral_ratio(lame, shear);
    k = (lame + 2 * shear) * (1 - ratio * ratio) * Real(1.0 / 12);
  }
  if constexpr (closure) k *= 1 - Real(row.cracked[i]);
  return k;
}

/// Sum over the K rows or columns with the weight of the far and of the near edge.
template <int K, class Real>
struct EdgeSums {
  Real near = 0, far = 0;
};
template <int K, class Real>
MPM_INLINE EdgeSums<K, Real> edge_sums(const Real (&s)[K]) {
  EdgeSums<K, Real> sums;
  unrolled<K>([&](auto p) __attribute__((always_inline)) {
    constexpr Real far = (Real(p.value) + Real(0.5)) / Real(K);
    sums.near += (1 - far) * s[p.value];
    sums.far += far * s[p.value];
  });
  return sums;
}

/// One cell: strains, stresses, suspicion and forces of its K x K points.
template <class Real, int K, bool one_poisson, Check check, bool closure, class Node>
MPM_INLINE Flag<Real> sweep_cell(const CellRow<Real, Node>& row, int i) {
  const EdgeStrains<Real> edges = edge_strains<Real>(row, i);
  CellSums<Real, K> sums{};
  Flag<Real> suspect = 0;
  unrolled<K * K>([&](auto p) __attribute__((always_inline)) {
    suspect |= add_point<Real, K, p.value, one_poisson, check, closure>(row, edges, i, sums);
  });
  const auto xx = edge_sums<K>(sums.xx);
  const auto yy = edge_sums<K>(sums.yy);
  const auto xy_col = edge_sums<K>(sums.xy_col);
  const auto xy_row = edge_sums<K>(sums.xy_row);
  // Minus the divergence of the linear weights: f = -sum over points of V grad(N) . s.
  row.lower.left_x[i] = xx.near + xy_col.near;
  row.lower.right_x[i] = xy_col.far - xx.near;
  row.upper.left_x[i] = xx.far - xy_col.near;
  row.upper.right_x[i] = -xx.far - xy_col.far;
  row.lower.left_y[i] = yy.near + xy_row.near;
  row.lower.right_y[i] = yy.far - xy_row.near;
  row.upper.left_y[i] = xy_row.far - yy.near;
  row.upper.right_y[i] = -yy.far - xy_row.far;
  if constexpr (check != Check::none) row.suspects[i] = suspect;
  return suspect;
}

/// Twice the mean strains of a cell times its size, and how its edges are bent, of one displacement.
template <class Real>
struct CellStrains {
  Real along_x, along_y, bent;
};

/// @param a, b, c, d  the displacement at the lower left, lower right, upper left and upper right node.
template <class Real, class Node>
MPM_INLINE CellStrains<Real> cell_strains(Node a, Node b, Node c, Node d) {
  const Real rising = Real(d - a);
  const Real falling = Real(b - c);
  const Real along_y = rising - falling;
  return {rising + falling, along_y, along_y + 2 * Real(a - c)};
}

/// One pixel cell: the stress at its centre, and the forces against its two bending modes, in which its
/// centre is not strained. It is written for few operations: they are what takes the time here.
template <class Real, bool one_poisson, Check check, bool closure, class Node>
MPM_INLINE Flag<Real> sweep_pixel(const CellRow<Real, Node>& row, int i) {
  const CellStrains<Real> x =
      cell_strains<Real>(row.ux_lower[i], row.ux_lower[i + 1], row.ux_upper[i], row.ux_upper[i + 1]);
  const CellStrains<Real> y =
      cell_strains<Real>(row.uy_lower[i], row.uy_lower[i + 1], row.uy_upper[i], row.uy_upper[i + 1]);
  constexpr Real half = Real(0.5);
  constexpr Real share = one_poisson ? Real(1) : half;  // with one Poisson ratio the units are halved already
  const Stress<Real> s = point_stress<Real, one_poisson, closure>(row, share * x.along_x, share * y.along_y,
                                                                  share * (x.along_y + y.along_x), i);
  const Flag<Real> suspect = is_suspect<check>(s, row, i);

  const Real weight = half * (one_poisson ? row.stiffness[i] : Real(1));
  const Real xx = weight * s.xx;
  const Real yy = weight * s.yy;
  const Real down_x = xx + weight * s.xy;  // of the corner at the lower left
  const Real down_y = yy + weight * s.xy;
  const Real side_x = weight * s.xy - xx;  // of that at the lower right
  const Real side_y = yy - weight * s.xy;
  const Real k = bending_stiffness<Real, one_poisson, closure>(row, i);
  row.lower.left_x[i] = down_x - k * x.bent;
  row.lower.right_x[i] = side_x + k * x.bent;
  row.upper.left_x[i] = k * x.bent - side_x;
  row.upper.right_x[i] = -(k * x.bent) - down_x;
  row.lower.left_y[i] = down_y - k * y.bent;
  row.lower.right_y[i] = side_y + k * y.bent;
  row.upper.left_y[i] = k * y.bent - side_y;
  row.upper.right_y[i] = -(k * y.bent) - down_y;
  if constexpr (check != Check::none) row.suspects[i] = suspect;
  return suspect;
}

template <class Real, int K, bool one_poisson, Check check, bool closure, bool pixel, class Node>
MPM_INLINE Flag<Real> sweep_one(const CellRow<Real, Node>& row, int i) {
  if constexpr (pixel) return sweep_pixel<Real, one_poisson, check, closure>(row, i);
  return sweep_cell<Real, K, one_poisson, check, closure>(row, i);
}

/// Of pixel cells, whose strains come twice as large.
template <class Real, class Node>
MPM_INLINE void halve_units(CellRow<Real, Node>& row) {
  row.unit_axial *= Real(0.5);
  row.unit_lateral *= Real(0.5);
  row.unit_shear *= Real(0.5);
}

// The body of a vector loop is one call: what it declares itself would be kept in memory, lane by lane.
template <class Real, int K, bool one_poisson, Check check, bool closure, bool pixel, class Node = double>
Flag<Real> sweep_cells(const CellRow<Real, Node>& row) {
  CellRow<Real, Node> in = row;
  if constexpr (pixel) halve_units(in);
  const int n = in.cells & ~(lane_cells - 1);
  Flag<Real> any = 0;
#pragma omp simd reduction(| : any)
  for (int i = 0; i < n; ++i) any |= sweep_one<Real, K, one_poisson, check, closure, pixel>(in, i);
  return any;
}

template <class Real>
MPM_INLINE double force(const Real* right_below, const Real* left_below, const Real* right_above,
                        const Real* left_above, int i) {
  // Node i is the left node of cell i and the right node of cell i - 1.
  return double((left_above[i] + right_above[i - 1]) + (left_below[i] + right_below[i - 1]));
}

MPM_INLINE double magnitude(double value) { return value < 0 ? -value : value; }

/// The force less the damping that opposes the motion. Source: local damping, Cundall (1987).
MPM_INLINE double damping_force(double f, double velocity, double damping) {
  return -damping * magnitude(f) * (velocity > 0 ? 1.0 : velocity < 0 ? -1.0 : 0.0);
}

template <class Real, bool damping, bool ledger>
NodeSums sweep_nodes(const NodeRow<Real>& row) {
  const int n = row.nodes & ~(lane_cells - 1);
  const NodeRow<Real> r = row;
  double momentum_rate = 0;
  double force_work = 0;
  double damped = 0;
  double velocity = 0;
#pragma omp simd reduction(+ : momentum_rate, force_work, damped, velocity)
  for (int i = 0; i < n; ++i) {
    const double fx = force(r.below.right_x, r.below.left_x, r.above.right_x, r.above.left_x, i);
    const double fy = force(r.below.right_y, r.below.left_y, r.above.right_y, r.above.left_y, i);
    const double w = r.impulse_over_mass[i];
    const double vx0 = r.vx[i];
    const double vy0 = r.vy[i];
    double total_x = fx;
    double total_y = fy;
    if constexpr (damping) {
      const double dx = damping_force(fx, vx0, r.damping);
      const double dy = damping_force(fy, vy0, r.damping);
      total_x += dx;
      total_y += dy;
      if (w > 0) damped -= 0.5 * (dx * (2 * vx0 + w * total_x) + dy * (2 * vy0 + w * total_y));
    }
    const double vx1 = vx0 + w * total_x;
    const double vy1 = vy0 + w * total_y;
    if constexpr (ledger) {
      if (w > 0) momentum_rate += (vx0 * vx1 + vy0 * vy1) / w;
      force_work += r.ux[i] * fx + r.uy[i] * fy;
    }
    velocity += vy1;
    r.vx[i] = vx1;
    r.vy[i] = vy1;
    r.ux[i] += r.dt * vx1;
    r.uy[i] += r.dt * vy1;
  }
  return {momentum_rate, force_work, damped, velocity};
}

template <class Real, int K, bool one_poisson, bool pixel>
SweepCells<Real> cells_by_check(const Features& f) {
  if (f.crack_closure) return sweep_cells<Real, K, one_poisson, Check::tension_and_shear, true, pixel>;
  switch (f.check) {
    case Check::none:
      return sweep_cells<Real, K, one_poisson, Check::none, false, pixel>;
    case Check::tension:
      return sweep_cells<Real, K, one_poisson, Check::tension, false, pixel>;
    case Check::tension_and_shear:
      break;
  }
  return sweep_cells<Real, K, one_poisson, Check::tension_and_shear, false, pixel>;
}

/// The usual cells, of one pixel or of 2 x 2 points, have kernels for every need.
template <class Real, int K, bool pixel>
SweepCells<Real> usual_cells(const Features& f) {
  return f.one_poisson_ratio ? cells_by_check<Real, K, true, pixel>(f)
                             : cells_by_check<Real, K, false, pixel>(f);
}

/// The rare numbers of points a cell have the general kernels only: a longer list would be compiled for
/// nobody.
template <class Real, int K>
SweepCells<Real> general_cells(const Features& f) {
  if (f.crack_closure) return sweep_cells<Real, K, false, Check::tension_and_shear, true, false>;
  if (f.check == Check::none) return sweep_cells<Real, K, false, Check::none, false, false>;
  return sweep_cells<Real, K, false, Check::tension_and_shear, false, false>;
}

template <class Real>
SweepCells<Real> cells(const Features& f) {
  if (f.pixel_cells) return usual_cells<Real, 1, true>(f);
  switch (f.points_per_cell) {
    case 1:
      return general_cells<Real, 1>(f);
    case 3:
      return general_cells<Real, 3>(f);
    case 4:
      return general_cells<Real, 4>(f);
    default:
      return usual_cells<Real, 2, false>(f);
  }
}

template <int K, bool one_poisson, bool pixel>
SweepCells<float, float> correction_of() {
  return sweep_cells<float, K, one_poisson, Check::none, false, pixel, float>;
}

SweepCells<float, float> corrections(const Features& f) {
  if (f.pixel_cells)
    return f.one_poisson_ratio ? correction_of<1, true, true>() : correction_of<1, false, true>();
  switch (f.points_per_cell) {
    case 1:
      return correction_of<1, false, false>();
    case 3:
      return correction_of<3, false, false>();
    case 4:
      return correction_of<4, false, false>();
    default:
      return f.one_poisson_ratio ? correction_of<2, true, false>() : correction_of<2, false, false>();
  }
}

template <class Real>
SweepNodes<Real> nodes(const Features& f) {
  if (f.damping) return f.ledger ? sweep_nodes<Real, true, true> : sweep_nodes<Real, true, false>;
  return f.ledger ? sweep_nodes<Real, false, true> : sweep_nodes<Real, false, false>;
}

}  // namespace

#define MPM_TEXT_OF(name) #name
#define MPM_TEXT(name) MPM_TEXT_OF(name)
extern const Kernels MPM_KERNELS = {MPM_TEXT(MPM_KERNELS), cells<float>,  cells<double>,
                                    nodes<float>,          nodes<double>, corrections};

}  // namespace mpm::kernels
