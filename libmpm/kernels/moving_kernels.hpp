/// The sweeps of moving points: over the points of a row of tiles, and over a row of nodes.
///
/// A tile is the area whose points share their nodes: a cell for linear shape functions (2 x 2 nodes), the
/// square around a node for quadratic ones (3 x 3 nodes). Each lane of a vector is one tile, so that the
/// nodes of the lanes are adjacent and are loaded and stored without gather, scatter or atomics. Sums over
/// points are taken in the order of their slots, by tiles, and then by the nodes of a tile: the same order
/// for any number of threads.
///
/// Like the sweeps of small strain they are compiled once per instruction set, do not allocate or throw, and
/// report by their return values.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libmpm/kernels/lattice_kernels.hpp"

namespace mpm::moving {

/// Fields of every point, in the order of its record. A record has one point per lane of a vector, field by
/// field. An empty lane has no mass, no volume and no stiffness.
enum Field : int {
  xi,      ///< place in the tile, from its left edge, over the width of a cell [-], in [0, 1)
  eta,     ///< the same, from its lower edge
  vx,      ///< velocity [m/s]
  vy,      ///< [m/s]
  mass,    ///< [kg/m]
  volume,  ///< [m^2]
  sxx,     ///< Cauchy stress, with crack closure that of the intact material [Pa]
  syy,     ///< [Pa]
  sxy,     ///< [Pa]
  lame,    ///< Lame constant of the plane [Pa]; 0 for a ghost point
  shear,   ///< shear modulus [Pa]; 0 for a ghost point
  basic_fields
};

/// Fields that only some runs need.
struct OptionalFields {
  bool tension = false;      ///< largest principal stress that the point survives [Pa]
  bool crush = false;        ///< smallest -s3 at which shear failure is possible [Pa]
  bool cracked = false;      ///< share of its tensile strength that a point has lost [-]
  bool affine = false;       ///< velocity gradient of APIC [1/s], row by row
  bool deformation = false;  ///< deformation gradient [-], row by row
};

/// Their positions in a record; -1 = absent.
struct RecordLayout {
  int fields = basic_fields;  ///< numbers of a point
  int tension = -1, crush = -1, cracked = -1, affine = -1, deformation = -1;
};

/// Zeros in front of a row of sums, and at least as many behind it.
inline constexpr int padding = 16;

/// Supports at the middle nodes of the outermost tiles of quadratic shapes. Nodes beyond a support move by
/// linear extrapolation from this node and the next one inside, so that points within half a cell of the
/// support have linear shapes: complete, and continuous with the next tile. Source: Steffen, Wallstedt,
/// Guilkey, Kirby, Berzins (2008), on B-splines at boundaries.
struct Folds {
  int left = -1, right = -1;          ///< columns of tiles; -1 = no support
  bool lower = false, upper = false;  ///< whether this is such a row
};

/// The points of a row of tiles: `lanes` tiles form a block; its points are in `used` records from `begin`
/// on.
template <class Real>
struct TileRow {
  Real* records;
  const std::int32_t* begin;  ///< first record, shape (blocks)
  const std::int32_t* used;   ///< number of records, shape (blocks)
  int blocks;
  RecordLayout layout;
  Real bottom;  ///< lower edge of the tiles over the height of a cell [-]
  Folds folds = {};
};

/// The nodes that a row of tiles touches: the first of them, left below.
template <class Real>
struct NodeVectors {
  const Real *x, *y;
  std::ptrdiff_t stride;  ///< between rows of nodes
};

/// Contributions of the points of a row of tiles to its nodes: plane (b N + a) n + f holds quantity f of n
/// for the node in column a and row b of each tile.
template <class Real>
struct Sums {
  Real* values;
  std::ptrdiff_t length;  ///< of a plane
};

/// Parameters of a step for all sweeps over points.
template <class Real>
struct Step {
  Real half_size;  ///< of a point, over the size of a cell [-]: 1/2 for the B-spline; unused by linear shapes
  Real hx, hy;     ///< size of a cell [m]
  Real dt;         ///< [s]
  Real hy_after;   ///< height of a cell at the end of the step [m]
  Real shrinkage;  ///< height of a cell at the beginning of the step over that at its end, less one [-]
  Real flip_ratio;  ///< [-]
  Real unilateral;  ///< 1: CrackClosure::unilateral, 0: clipped
};

enum class Stencil { linear, quadratic };
enum class Return { flip, blend, apic };

/// Mass [kg/m] and momentum [kg/s] of the points (3 quantities), and their internal force [N/m] (2
/// quantities): both in one sweep, or only one of them.
template <class Real>
using Scatter = void (*)(const TileRow<Real>&, const Step<Real>&, Sums<Real> momentum, Sums<Real> force);
/// Velocity of the points from that of the nodes at the end of the step and its change in it. APIC does not
/// need the change; with linear shapes it takes the gradient from `change`, which then is a velocity that is
/// bounded at light nodes: the gradient of a linear shape does not vanish with its weight.
/// @param[out] momentum  of the points with their new velocity [kg/s], 2 quantities, where the sweep maps it
///   back.   @return the largest square of a speed [m^2/s^2].
template <class Real>
using Gather = Real (*)(const TileRow<Real>&, const Step<Real>&, NodeVectors<Real> change,
                        NodeVectors<Real> fresh, Sums<Real> momentum);
/// Events of points, for the flags of the blocks.
enum Flag : std::uint8_t {
  may_fail = 1,
  has_left = 2,  ///< its tile
};
/// Stress and volume of the points from the gradient of the straining velocity (Jaumann rate), and positions
/// from the velocity at the end of the step: both in one sweep, or only one of them.
/// @param[out] flags  events of the points of each block, shape (blocks).   @return events of all points.
template <class Real>
using Follow = int (*)(const TileRow<Real>&, const Step<Real>&, NodeVectors<Real> straining,
                       NodeVectors<Real> fresh, std::uint8_t* flags);
/// Deformation gradient F from the gradient of the straining velocity; before the points move.
template <class Real>
using Deform = void (*)(const TileRow<Real>&, const Step<Real>&, NodeVectors<Real> straining);

/// Energies of the points of a row of tiles [J/m].
struct Energies {
  double kinetic = 0, elastic = 0;
};
template <class Real>
using MeasureEnergies = Energies (*)(const TileRow<Real>&, const Step<Real>&);

/// Sums of up to three rows of tiles that meet in a row of nodes: `tiles[b]` is the row of which it is row b.
template <class Real>
struct NodeRow {
  const Real* tiles[3];
  std::ptrdiff_t length;  ///< of a plane
  int nodes;              ///< padded number of nodes
};

/// Velocity [m/s] of the nodes from their mass and momentum. A node of less than `least_mass` stands still.
template <class Real>
using SumMomentum = void (*)(const NodeRow<Real>&, Real least_mass, Real* mass, Real* vx, Real* vy);
/// The same from the momentum that was mapped back; the mass has not changed.
template <class Real>
using SumNewMomentum = void (*)(const NodeRow<Real>&, Real least_mass, const Real* mass, Real* vx, Real* vy);

/// A step of a row of nodes.
template <class Real>
struct Integration {
  NodeRow<Real> forces;
  Real dt, damping, least_mass;
  const Real *mass, *vx, *vy;  ///< at the beginning of the step
  Real *fresh_x, *fresh_y;     ///< out: velocity at its end [m/s]
  Real *change_x, *change_y;   ///< out: its change [m/s]
  /// A node below it gains speed that its points hardly see, so that damping takes less from it than f^2 / m
  /// says, which has no bound [kg/m].
  Real light_mass = 0;
};
/// @return energy dissipated by local damping [J/m].
template <class Real>
using Integrate = double (*)(const Integration<Real>&);

/// Compile-time options of the sweeps.
struct Features {
  Stencil stencil = Stencil::quadratic;
  Return transfer = Return::flip;
  kernels::Check check = kernels::Check::tension_and_shear;
  bool crack_closure = false;
  bool damping = false;
};

/// The sweeps of one run.
template <class Real>
struct Sweeps {
  int lanes;
  Scatter<Real> scatter, scatter_momentum, scatter_force;
  Gather<Real> gather, gather_and_map_back;
  Follow<Real> strain, move, strain_and_move;
  Deform<Real> deform;
  MeasureEnergies<Real> measure_energies;
  SumMomentum<Real> sum_momentum;
  SumNewMomentum<Real> sum_new_momentum;
  Integrate<Real> integrate;
};

/// The kernels of one instruction set.
struct Kernels {
  const char* name;
  Sweeps<float> (*in_single)(const Features&);
  Sweeps<double> (*in_double)(const Features&);

  template <class Real>
  [[nodiscard]] Sweeps<Real> sweeps(const Features& features) const {
    if constexpr (sizeof(Real) == sizeof(float))
      return in_single(features);
    else
      return in_double(features);
  }
};

extern const Kernels baseline;
#ifdef __x86_64__
extern const Kernels avx2;
extern const Kernels avx512;
#endif

}  // namespace mpm::moving
