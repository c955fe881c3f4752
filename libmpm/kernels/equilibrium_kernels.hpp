/// The sweeps of equilibrium without inertia: coarse cells, and what a row of nodes does in a cycle of
/// multigrid and in conjugate gradients.
///
/// Like the sweeps of small strain they are compiled once per instruction set, do not allocate or throw, and
/// work on rows that may be read and written up to the next multiple of `lane_cells`. Forces are those on the
/// nodes, minus the stiffness times the displacement. What corrects the displacements has 32 bits, or 64.
#pragma once

#include <cstddef>

#include "libmpm/kernels/lattice_kernels.hpp"

namespace mpm::equilibrium {

/// Entries of the upper triangle of the stiffness of a cell: of its five modes, and of its nodes.
inline constexpr int mode_entries = 15;
inline constexpr int node_entries = 36;

/// A row of coarse cells given by their matrices: planes of one entry each, row by row of the upper triangle,
/// in the order of CellModes or CellStiffness.
template <class Real>
struct MatrixRow {
  int cells;                                              ///< padded number of cells
  std::ptrdiff_t stride;                                  ///< between planes
  const float* matrices;                                  ///< [Pa]
  const float* slant;                                     ///< height over width of each cell; for modes [-]
  const Real *ux_lower, *uy_lower, *ux_upper, *uy_upper;  ///< displacements of the two rows of nodes [m]
  kernels::NodeForces<Real> lower, upper;                 ///< out
};

/// A row of nodes between two rows of cells.
template <class Real>
struct NodeRow {
  int nodes;                                         ///< padded number of nodes
  kernels::NodeForces<const Real> below, above;      ///< of the cells
  const Real *load_x, *load_y;                       ///< forces from outside
  const Real *inverse_xx, *inverse_xy, *inverse_yy;  ///< inverse of the stiffness of each node; its
                                                     ///< diagonal is 0 for what is no unknown
  Real weight;                                       ///< of the relaxation [-]
  Real *x, *y;  ///< in: displacement that the forces belong to; out: what the sweep makes of it
};

/// A row of a vector at every node, x and y.
template <class Real>
struct Values {
  Real *x, *y;
};

/// A row of nodes between two rows of cells, in 64 bits.
template <class Real>
struct ForceRow {
  int nodes;                                       ///< padded number of nodes
  kernels::NodeForces<const double> below, above;  ///< of the cells
  Values<const double> u;                          ///< displacements
  const Real *inverse_xx, *inverse_yy;             ///< as in NodeRow
  Values<Real> x;                                  ///< out
};

/// Sums over a row of nodes.
struct NodeSums {
  double work;     ///< of the forces times the displacements
  double force_y;  ///< of the forces along y
};

/// The points at one place of each cell of a row.
struct PointRow {
  int cells;                                                ///< padded number of cells
  const double *ux_lower, *uy_lower, *ux_upper, *uy_upper;  ///< displacements of the two rows of nodes [m]
  double xi, eta;                                           ///< place in the cell, in [0, 1]
  double scale;                                             ///< on the displacements [1/m]
  const double* stiffness;                                  ///< as in CellRow
  const double* shear;                                      ///< as in CellRow; nullptr with one Poisson ratio
  double unit_axial, unit_lateral, unit_shear;
  const float* tension;  ///< 1 / largest principal stress that a point survives [1/Pa]; 0 = any
  const float* crush;    ///< the same for minus the smallest one; 0 = any
  double crush_share;    ///< what the largest one adds to that in a point that may be crushed [1/Pa]
};

/// The sweeps of what corrects the displacements.
template <class Real>
struct Corrections {
  void (*multiply_modes)(const MatrixRow<Real>&);   ///< matrices of mode_entries planes
  void (*multiply_nodes)(const MatrixRow<Real>&);   ///< matrices of node_entries planes
  void (*first_relax)(const NodeRow<Real>&);        ///< x = weight inverse load
  void (*relax)(const NodeRow<Real>&);              ///< x += weight inverse (load + forces)
  void (*residual)(const NodeRow<Real>&);           ///< x = load + forces, 0 for what is no unknown
  void (*forces)(const NodeRow<Real>&);             ///< x = forces, 0 for what is no unknown
  NodeSums (*known_forces)(const ForceRow<Real>&);  ///< the same, rounded from 64 bits
  /// Sets to 0 what is no unknown.
  void (*leave_unknowns)(int nodes, const Real* inverse, Real* values);
  /// Nodes of a coarse row with two cells of the finer grid on each side: from the fine row at its place, and
  /// those below and above it.
  void (*restrict_row)(int nodes, const Real* below, const Real* at, const Real* above, Real* coarse);
  /// Adds to a fine row what lies between two coarse ones, from the left end of so many of their cells, which
  /// hold two fine ones each, up to the right end.   @param up  weight of the upper row [-].
  void (*interpolate_row)(int cells, Real up, const Real* lower, const Real* upper, Real* fine);
  double (*dot)(int nodes, Values<const Real> a, Values<const Real> b);
  /// direction = z + factor direction
  void (*turn)(int nodes, Real factor, Values<const Real> z, Values<Real> direction);
  /// u += factor direction, residual += factor image
  void (*advance)(int nodes, Real factor, Values<const Real> direction, Values<const Real> image,
                  Values<double> u, Values<Real> residual);
};

struct Kernels {
  Corrections<float> single;
  Corrections<double> whole;
  NodeSums (*all_forces)(const ForceRow<double>&);  ///< x = forces, also on what is no unknown
  /// The largest utilisation: that of the largest principal stress, or of both if crushed.
  double (*largest_utilisation)(const PointRow&);

  template <class Real>
  [[nodiscard]] const Corrections<Real>& corrections() const {
    if constexpr (sizeof(Real) == sizeof(float))
      return single;
    else
      return whole;
  }
};

extern const Kernels baseline;
#ifdef __x86_64__
extern const Kernels avx2;
extern const Kernels avx512;
#endif

}  // namespace mpm::equilibrium
