// Compiled once per instruction set, with MPM_KERNELS naming the table that it defines; see
// lattice_kernels.cpp.
#include "libmpm/kernels/equilibrium_kernels.hpp"

#include "libmpm/kernels/unroll.hpp"
#include "libmpm/material/stress.hpp"

namespace mpm::equilibrium {
namespace {

/// Place of an entry in the upper triangle of a matrix of n x n, row by row.
constexpr int entry(int n, int row, int col) {
  return row <= col ? row * (2 * n - 1 - row) / 2 + col : entry(n, col, row);
}

/// out -= matrix of cell i times in.
template <class Real, int N>
MPM_INLINE void subtract_product(const MatrixRow<Real>& row, int i, const Real (&in)[N], Real (&out)[N]) {
  unrolled<N>([&](auto r) __attribute__((always_inline)) {
    unrolled<N>([&](auto c) __attribute__((always_inline)) {
      out[r.value] -= Real(row.matrices[entry(N, r.value, c.value) * row.stride + i]) * in[c.value];
    });
  });
}

/// The modes are differences of neighbours, so that a large motion without strain costs no digits.
template <class Real>
MPM_INLINE void multiply_modes_of(const MatrixRow<Real>& row, int i) {
  const Real *ux0 = row.ux_lower, *uy0 = row.uy_lower, *ux1 = row.ux_upper, *uy1 = row.uy_upper;
  const Real bottom_x = ux0[i + 1] - ux0[i];
  const Real top_x = ux1[i + 1] - ux1[i];
  const Real bottom_y = uy0[i + 1] - uy0[i];
  const Real top_y = uy1[i + 1] - uy1[i];
  const Real slant = Real(row.slant[i]);
  const Real shear = (ux1[i] - ux0[i]) + (ux1[i + 1] - ux0[i + 1]) + slant * (bottom_y + top_y);
  const Real modes[5] = {bottom_x + top_x, (uy1[i] - uy0[i]) + (uy1[i + 1] - uy0[i + 1]), shear,
                         top_x - bottom_x, top_y - bottom_y};
  Real s[5] = {0, 0, 0, 0, 0};
  subtract_product(row, i, modes, s);
  row.lower.left_x[i] = s[3] - (s[0] + s[2]);
  row.lower.right_x[i] = (s[0] - s[2]) - s[3];
  row.upper.left_x[i] = (s[2] - s[0]) - s[3];
  row.upper.right_x[i] = (s[0] + s[2]) + s[3];
  const Real t = slant * s[2];
  row.lower.left_y[i] = s[4] - (s[1] + t);
  row.lower.right_y[i] = (t - s[1]) - s[4];
  row.upper.left_y[i] = (s[1] - t) - s[4];
  row.upper.right_y[i] = (s[1] + t) + s[4];
}

template <class Real>
MPM_INLINE void multiply_nodes_of(const MatrixRow<Real>& row, int i) {
  const Real u[8] = {row.ux_lower[i], row.ux_lower[i + 1], row.ux_upper[i], row.ux_upper[i + 1],
                     row.uy_lower[i], row.uy_lower[i + 1], row.uy_upper[i], row.uy_upper[i + 1]};
  Real f[8] = {0, 0, 0, 0, 0, 0, 0, 0};
  subtract_product(row, i, u, f);
  row.lower.left_x[i] = f[0];
  row.lower.right_x[i] = f[1];
  row.upper.left_x[i] = f[2];
  row.upper.right_x[i] = f[3];
  row.lower.left_y[i] = f[4];
  row.lower.right_y[i] = f[5];
  row.upper.left_y[i] = f[6];
  row.upper.right_y[i] = f[7];
}

constexpr int whole_lanes(int n) { return n & ~(kernels::lane_cells - 1); }

template <class Real>
void multiply_modes(const MatrixRow<Real>& row) {
  const MatrixRow<Real> in = row;
  const int n = whole_lanes(in.cells);
#pragma omp simd
  for (int i = 0; i < n; ++i) multiply_modes_of(in, i);
}

template <class Real>
void multiply_nodes(const MatrixRow<Real>& row) {
  const MatrixRow<Real> in = row;
  const int n = whole_lanes(in.cells);
#pragma omp simd
  for (int i = 0; i < n; ++i) multiply_nodes_of(in, i);
}

template <class Real>
MPM_INLINE Real force(const Real* right_below, const Real* left_below, const Real* right_above,
                      const Real* left_above, int i) {
  return (left_above[i] + right_above[i - 1]) + (left_below[i] + right_below[i - 1]);
}

enum class Sweep { first_relax, relax, residual, forces };

template <class Real, Sweep kind>
void sweep(const NodeRow<Real>& row) {
  const NodeRow<Real> r = row;
  const int n = whole_lanes(r.nodes);
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    Real fx = 0;
    Real fy = 0;
    if constexpr (kind != Sweep::first_relax) {
      fx = force(r.below.right_x, r.below.left_x, r.above.right_x, r.above.left_x, i);
      fy = force(r.below.right_y, r.below.left_y, r.above.right_y, r.above.left_y, i);
    }
    if constexpr (kind != Sweep::forces) {
      fx += r.load_x[i];
      fy += r.load_y[i];
    }
    if constexpr (kind == Sweep::residual || kind == Sweep::forces) {
      r.x[i] = r.inverse_xx[i] > 0 ? fx : 0;
      r.y[i] = r.inverse_yy[i] > 0 ? fy : 0;
    } else {
      const Real x = r.weight * (r.inverse_xx[i] * fx + r.inverse_xy[i] * fy);
      const Real y = r.weight * (r.inverse_xy[i] * fx + r.inverse_yy[i] * fy);
      r.x[i] = kind == Sweep::first_relax ? x : r.x[i] + x;
      r.y[i] = kind == Sweep::first_relax ? y : r.y[i] + y;
    }
  }
}

template <class Real>
MPM_INLINE Real restricted(const Real* below, const Real* at, const Real* above, int i) {
  return at[i] + Real(0.5) * (below[i] + above[i]);
}

/// Rows have zeros behind their last node.
template <class Real>
void restrict_row(int nodes, const Real* below, const Real* at, const Real* above, Real* coarse) {
  if (nodes > 0) coarse[0] = restricted(below, at, above, 0) + Real(0.5) * restricted(below, at, above, 1);
#pragma omp simd
  for (int i = 1; i < nodes; ++i)
    coarse[i] = restricted(below, at, above, 2 * i) + Real(0.5) * (restricted(below, at, above, 2 * i - 1) +
                                                                   restricted(below, at, above, 2 * i + 1));
}

template <class Real>
void interpolate_row(int cells, Real up, const Real* lower, const Real* upper, Real* fine) {
  const Real down = 1 - up;
#pragma omp simd
  for (int i = 0; i < cells; ++i) {
    const Real left = down * lower[i] + up * upper[i];
    const Real right = down * lower[i + 1] + up * upper[i + 1];
    fine[2 * i] += left;
    fine[2 * i + 1] += Real(0.5) * (left + right);
  }
}

template <class Real>
void leave_unknowns(int nodes, const Real* inverse, Real* values) {
  const int n = whole_lanes(nodes);
#pragma omp simd
  for (int i = 0; i < n; ++i) values[i] = inverse[i] > 0 ? values[i] : 0;
}

template <class Real, bool masked>
NodeSums gather_forces(const ForceRow<Real>& row) {
  const ForceRow<Real> r = row;
  const int n = whole_lanes(r.nodes);
  double work = 0;
  double force_y = 0;
#pragma omp simd reduction(+ : work, force_y)
  for (int i = 0; i < n; ++i) {
    const double fx = force(r.below.right_x, r.below.left_x, r.above.right_x, r.above.left_x, i);
    const double fy = force(r.below.right_y, r.below.left_y, r.above.right_y, r.above.left_y, i);
    work += r.u.x[i] * fx + r.u.y[i] * fy;
    force_y += fy;
    r.x.x[i] = masked && !(r.inverse_xx[i] > 0) ? Real(0) : Real(fx);
    r.x.y[i] = masked && !(r.inverse_yy[i] > 0) ? Real(0) : Real(fy);
  }
  return {work, force_y};
}

template <bool one_poisson>
MPM_INLINE double utilisation(const PointRow& r, int i) {
  const double bottom_x = r.ux_lower[i + 1] - r.ux_lower[i];
  const double top_x = r.ux_upper[i + 1] - r.ux_upper[i];
  const double bottom_y = r.uy_lower[i + 1] - r.uy_lower[i];
  const double top_y = r.uy_upper[i + 1] - r.uy_upper[i];
  const double left_x = r.ux_upper[i] - r.ux_lower[i];
  const double right_x = r.ux_upper[i + 1] - r.ux_lower[i + 1];
  const double left_y = r.uy_upper[i] - r.uy_lower[i];
  const double right_y = r.uy_upper[i + 1] - r.uy_lower[i + 1];
  const double exx = r.scale * ((1 - r.eta) * bottom_x + r.eta * top_x);
  const double eyy = r.scale * ((1 - r.xi) * left_y + r.xi * right_y);
  const double gxy =
      r.scale * ((1 - r.xi) * left_x + r.xi * right_x + (1 - r.eta) * bottom_y + r.eta * top_y);
  Stress<double> s;
  if constexpr (one_poisson)
    s = {r.stiffness[i] * (r.unit_axial * exx + r.unit_lateral * eyy),
         r.stiffness[i] * (r.unit_lateral * exx + r.unit_axial * eyy), r.stiffness[i] * r.unit_shear * gxy};
  else
    s = elastic_stress(r.stiffness[i], r.shear[i], exx, eyy, gxy);
  const double mean = 0.5 * (s.xx + s.yy);
  const double deviator = 0.5 * (s.xx - s.yy);
  const double radius = square_root(deviator * deviator + s.xy * s.xy);
  const double first = mean + radius > 0 ? mean + radius : 0;
  const double last = radius - mean > 0 ? radius - mean : 0;
  const double in_tension = first * double(r.tension[i]);
  const double crush = double(r.crush[i]);
  const double crushed = last * crush + (crush > 0 ? first * r.crush_share : 0);
  return in_tension > crushed ? in_tension : crushed;
}

template <bool one_poisson>
double largest_of_row(const PointRow& row) {
  const PointRow r = row;
  const int n = whole_lanes(r.cells);
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (int i = 0; i < n; ++i) {
    const double one = utilisation<one_poisson>(r, i);
    largest = one > largest ? one : largest;
  }
  return largest;
}

double largest_utilisation(const PointRow& row) {
  return row.shear == nullptr ? largest_of_row<true>(row) : largest_of_row<false>(row);
}

template <class Real>
double dot(int nodes, Values<const Real> a, Values<const Real> b) {
  const int n = whole_lanes(nodes);
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (int i = 0; i < n; ++i) sum += double(a.x[i]) * double(b.x[i]) + double(a.y[i]) * double(b.y[i]);
  return sum;
}

template <class Real>
void turn(int nodes, Real factor, Values<const Real> z, Values<Real> direction) {
  const int n = whole_lanes(nodes);
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    direction.x[i] = z.x[i] + factor * direction.x[i];
    direction.y[i] = z.y[i] + factor * direction.y[i];
  }
}

template <class Real>
void advance(int nodes, Real factor, Values<const Real> direction, Values<const Real> image, Values<double> u,
             Values<Real> residual) {
  const int n = whole_lanes(nodes);
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    u.x[i] += double(factor) * double(direction.x[i]);
    u.y[i] += double(factor) * double(direction.y[i]);
    residual.x[i] += factor * image.x[i];
    residual.y[i] += factor * image.y[i];
  }
}

template <class Real>
constexpr Corrections<Real> corrections() {
  return {multiply_modes<Real>,
          multiply_nodes<Real>,
          sweep<Real, Sweep::first_relax>,
          sweep<Real, Sweep::relax>,
          sweep<Real, Sweep::residual>,
          sweep<Real, Sweep::forces>,
          gather_forces<Real, true>,
          leave_unknowns<Real>,
          restrict_row<Real>,
          interpolate_row<Real>,
          dot<Real>,
          turn<Real>,
          advance<Real>};
}

}  // namespace

extern const Kernels MPM_KERNELS = {corrections<float>(), corrections<double>(), gather_forces<double, false>,
                                    largest_utilisation};

}  // namespace mpm::equilibrium
