/// The two sweeps of small strain: over the points of a row of cells, and over a row of nodes. Almost all
/// time of a run is spent here.
///
/// The sweeps are compiled once per instruction set from one source and chosen when the program runs. They
/// allocate nothing, throw nothing, and report by what they return. All lengths are padded: every row may be
/// read and written up to the next multiple of `lane_cells` cells.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mpm::kernels {

/// Rows are padded to a multiple of this many cells.
inline constexpr int lane_cells = 16;

/// A threshold that no stress reaches; its square is still finite in 32 bits.
inline constexpr float unreachable = 1e18F;

/// Integer of the width of Real: comparisons stay in lanes of one width.
template <class Real>
struct FlagOf {
  using type = std::int64_t;
};
template <>
struct FlagOf<float> {
  using type = std::int32_t;
};
template <class Real>
using Flag = typename FlagOf<Real>::type;

/// Forces that the points of a row of cells exert on one row of its nodes: by the node at the left and at the
/// right of each cell, shape (n_cells) each, with one readable zero in front. Unit: [Pa m] times the scale of
/// NodeRow.
template <class Real>
struct NodeForces {
  Real *left_x, *right_x, *left_y, *right_y;
};

/// What the sweep over a row of cells reads and writes. The K x K points of a cell are K x K planes: plane p
/// = b K + a holds the points of column a and row b (from the bottom) of each cell of the row.
/// @tparam Node  precision of the displacements.
template <class Real, class Node = double>
struct CellRow {
  int cells;                                              ///< padded number of cells
  std::ptrdiff_t stride;                                  ///< between planes
  const Node *ux_lower, *uy_lower, *ux_upper, *uy_upper;  ///< displacements of the two rows of nodes [m]
  const Real* stiffness;  ///< E (one Poisson ratio) or the Lame constant; times the volume share [Pa]
  const Real* shear;      ///< shear modulus times the volume share [Pa]; unused with one Poisson ratio
  const float* tension;   ///< tensile threshold, in the scale of the stress of this kernel
  const float* crush;     ///< smallest -s3 at which shear failure is possible, in the same scale
  const float* cracked;   ///< share of its tensile strength that a point has lost [-]
  Real unilateral;        ///< 1: CrackClosure::unilateral, 0: clipped
  Real unit_axial, unit_lateral, unit_shear;  ///< stiffness of a phase with E = 1 [-]
  Real unit_bending;  ///< stiffness of a pixel cell against bending with E = 1 [-]; otherwise unused
  NodeForces<Real> lower, upper;  ///< out
  Flag<Real>* suspects;           ///< out: nonzero for a cell in which a point may fail
};

/// What the sweep over a row of nodes reads and writes.
template <class Real>
struct NodeRow {
  int nodes;                     ///< padded number of nodes
  NodeForces<const Real> below;  ///< from the row of cells below
  NodeForces<const Real> above;  ///< from the row of cells above
  double *ux, *uy;               ///< displacement [m]
  double *vx, *vy;               ///< velocity [m/s]
  const double*
      impulse_over_mass;  ///< dt times the force scale over the nodal mass; 0 where there is no mass
  double dt;              ///< [s]
  double damping;         ///< local damping [-]
};

/// Sums over a row of nodes, in the units of NodeRow.
struct NodeSums {
  double momentum_rate;  ///< sum of v_old . v_new / impulse_over_mass: twice the kinetic energy over dt
  double force_work;     ///< sum of u . f: minus twice the elastic energy
  double damped;         ///< sum of the damping force times the mean velocity
  double velocity;       ///< sum of v_y: finite as long as every number is; what is not a number goes from
                         ///< one component to the other in a step
};

/// Which failures are checked.
enum class Check { none, tension, tension_and_shear };

struct Features {
  int points_per_cell = 2;         ///< along an edge
  bool pixel_cells = false;        ///< the one point of a cell stands for all of it
  bool one_poisson_ratio = false;  ///< all phases share one
  Check check = Check::tension_and_shear;
  bool crack_closure = false;
  bool damping = false;
  bool ledger = false;  ///< compute NodeSums::momentum_rate and force_work
};

/// @return nonzero if some cell of the row is suspect.
template <class Real, class Node = double>
using SweepCells = Flag<Real> (*)(const CellRow<Real, Node>&);
template <class Real>
using SweepNodes = NodeSums (*)(const NodeRow<Real>&);

/// The kernels of one instruction set.
struct Kernels {
  const char* name;
  SweepCells<float> (*cells_single)(const Features&);
  SweepCells<double> (*cells_double)(const Features&);
  SweepNodes<float> (*nodes_single)(const Features&);
  SweepNodes<double> (*nodes_double)(const Features&);
  SweepCells<float, float> (*corrections)(const Features&);  ///< all in 32 bits; no check, no closure

  template <class Real>
  [[nodiscard]] SweepCells<Real> cells(const Features& features) const {
    if constexpr (sizeof(Real) == sizeof(float))
      return cells_single(features);
    else
      return cells_double(features);
  }
  template <class Real>
  [[nodiscard]] SweepNodes<Real> nodes(const Features& features) const {
    if constexpr (sizeof(Real) == sizeof(float))
      return nodes_single(features);
    else
      return nodes_double(features);
  }
};

extern const Kernels baseline;
#ifdef __x86_64__
extern const Kernels avx2;
extern const Kernels avx512;
#endif

}  // namespace mpm::kernels
