/// The sweeps of equilibrium without inertia: cells given by their matrices, and relaxation of a row of
/// nodes.
///
/// Like the sweeps of small strain they are compiled once per instruction set, do not allocate or throw, and
/// work on rows that may be read and written up to the next multiple of `lane_cells`. Forces are those on the
/// nodes, minus the stiffness times the displacement.
#pragma once

#include <cstddef>

#include "libmpm/kernels/lattice_kernels.hpp"

namespace mpm::equilibrium {

/// Entries of the upper triangle of the matrix of a cell.
inline constexpr int matrix_entries = 36;

/// A row of cells given by their matrices: matrix_entries planes, row by row of the upper triangle, in the
/// order of CellStiffness.
struct MatrixRow {
  int cells;                                                ///< padded number of cells
  std::ptrdiff_t stride;                                    ///< between planes
  const float* matrices;                                    ///< [Pa]
  const double *ux_lower, *uy_lower, *ux_upper, *uy_upper;  ///< displacements of the two rows of nodes [m]
  kernels::NodeForces<double> lower, upper;                 ///< out
};

/// A row of nodes between two rows of cells.
struct RelaxRow {
  int nodes;                                           ///< padded number of nodes
  kernels::NodeForces<const double> below, above;      ///< of the cells
  const double *load_x, *load_y;                       ///< forces from outside
  const double *inverse_xx, *inverse_xy, *inverse_yy;  ///< inverse of the stiffness of each node
  double weight;                                       ///< of the relaxation [-]
  double *x,
      *y;  ///< in: displacement that the forces belong to; out: relaxed, or with `residual` the residual
};

struct Kernels {
  void (*multiply)(const MatrixRow&);
  void (*relax)(const RelaxRow&);     ///< x += weight inverse (load + forces)
  void (*residual)(const RelaxRow&);  ///< x = load + forces
};

extern const Kernels baseline;
#ifdef __x86_64__
extern const Kernels avx2;
extern const Kernels avx512;
#endif

}  // namespace mpm::equilibrium
