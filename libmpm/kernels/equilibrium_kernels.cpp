// Compiled once per instruction set, with MPM_KERNELS naming the table that it defines; see
// lattice_kernels.cpp.
#include "libmpm/kernels/equilibrium_kernels.hpp"

#include "libmpm/kernels/unroll.hpp"

namespace mpm::equilibrium {
namespace {

/// Place of an entry in the upper triangle, row by row.
constexpr int entry(int row, int col) { return row <= col ? row * (15 - row) / 2 + col : entry(col, row); }

MPM_INLINE void multiply_cell(const MatrixRow& row, int i) {
  const double u[8] = {row.ux_lower[i], row.ux_lower[i + 1], row.ux_upper[i], row.ux_upper[i + 1],
                       row.uy_lower[i], row.uy_lower[i + 1], row.uy_upper[i], row.uy_upper[i + 1]};
  double f[8] = {0, 0, 0, 0, 0, 0, 0, 0};
  unrolled<8>([&](auto r) __attribute__((always_inline)) {
    unrolled<8>([&](auto c) __attribute__((always_inline)) {
      f[r.value] -= double(row.matrices[entry(r.value, c.value) * row.stride + i]) * u[c.value];
    });
  });
  row.lower.left_x[i] = f[0];
  row.lower.right_x[i] = f[1];
  row.upper.left_x[i] = f[2];
  row.upper.right_x[i] = f[3];
  row.lower.left_y[i] = f[4];
  row.lower.right_y[i] = f[5];
  row.upper.left_y[i] = f[6];
  row.upper.right_y[i] = f[7];
}

void multiply(const MatrixRow& row) {
  const MatrixRow in = row;
  const int n = in.cells & ~(kernels::lane_cells - 1);
#pragma omp simd
  for (int i = 0; i < n; ++i) multiply_cell(in, i);
}

MPM_INLINE double force(const double* right_below, const double* left_below, const double* right_above,
                        const double* left_above, int i) {
  return (left_above[i] + right_above[i - 1]) + (left_below[i] + right_below[i - 1]);
}

template <bool residual>
void sweep(const RelaxRow& row) {
  const RelaxRow r = row;
  const int n = r.nodes & ~(kernels::lane_cells - 1);
#pragma omp simd
  for (int i = 0; i < n; ++i) {
    const double fx =
        r.load_x[i] + force(r.below.right_x, r.below.left_x, r.above.right_x, r.above.left_x, i);
    const double fy =
        r.load_y[i] + force(r.below.right_y, r.below.left_y, r.above.right_y, r.above.left_y, i);
    if constexpr (residual) {
      r.x[i] = fx;
      r.y[i] = fy;
    } else {
      r.x[i] += r.weight * (r.inverse_xx[i] * fx + r.inverse_xy[i] * fy);
      r.y[i] += r.weight * (r.inverse_xy[i] * fx + r.inverse_yy[i] * fy);
    }
  }
}

}  // namespace

extern const Kernels MPM_KERNELS = {multiply, sweep<false>, sweep<true>};

}  // namespace mpm::equilibrium
