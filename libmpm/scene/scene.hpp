/// A scene: plain data that defines a run completely.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/fixture.hpp"
#include "libmpm/scene/phase.hpp"

namespace mpm {

/// The loading by the platens.
enum class Direction {
  tension,
  compression,
  none,  ///< no platens: the specimen starts with an initial velocity; needs moving points
};

/// How a platen holds the specimen sideways: smooth = free (one node fixed), rough = no sideways motion.
enum class Platen { smooth, rough };

/// Which states a quasi-static run goes through.
enum class LoadingPath {
  strain,     ///< the platens never go back; the stress drops while they stand still
  snap_back,  ///< the platens move on or back to the strain at which the next point fails
};

/// Floating-point precision of the solver.
enum class Precision {
  single,   ///< stresses in 32 bits, motion of the nodes in 64 bits
  double_,  ///< 64 bits throughout
};

/// The kinematics of the material points.
enum class Kinematics {
  small_strain,  ///< points keep their place; their stress follows from the nodal displacements
  moving,        ///< points move through the grid and carry velocity and stress
  automatic,     ///< small strain up to a limit of Handover, then moving points
};

/// Shape functions of moving points.
enum class Shape {
  linear,   ///< bilinear; Sulsky, Chen, Schreyer (1994)
  gimp,     ///< uniform generalised interpolation; Bardenhagen, Kober (2004)
  bspline,  ///< quadratic B-spline; Steffen, Kirby, Berzins (2008)
};

/// When a step updates the stress.
enum class Scheme {
  usf,   ///< first, from the momentum mapped from the points
  usl,   ///< last, from the nodal velocity at the end of the step; with APIC the same as musl
  musl,  ///< last, from the new point velocities mapped back to the nodes; Sulsky, Zhou, Schreyer (1995)
};

/// How the points take their velocity from the nodes.
enum class Transfer {
  flip,  ///< they add the change of the nodal velocity; Motion::flip_ratio blends it with the value (PIC)
  apic,  ///< they take its value and its gradient; Jiang, Schroeder, Selle, Teran, Stomakhin (2015)
};

/// Boundary condition at an edge of the grid of moving points.
enum class Edge {
  closed,       ///< none; a point that leaves here stops the run with an error
  open,         ///< none; points that leave here are removed and counted
  symmetry,     ///< plane of symmetry: no motion across it
  smooth_wall,  ///< frictionless wall; the specimen may separate from it
  rough_wall,   ///< wall without sliding; the specimen may separate from it
};

/// An additional material point. All points in a pixel share its volume.
struct ExtraPoint {
  double x = 0;            ///< from the left edge of the specimen [m]
  double y = 0;            ///< from its lower edge [m]
  std::uint8_t phase = 0;  ///< label
};

/// Loading between platens, or free flight without them.
struct Loading {
  Direction direction = Direction::tension;
  double velocity = 0.05;  ///< speed of the top platen [m/s], > 0
  double ramp_time =
      -1;  ///< time from rest to full velocity [s]; < 0 = two transits of the slowest wave, see Plan
  Platen platen = Platen::smooth;
  LoadingPath path = LoadingPath::strain;  ///< quasi-static
  double stop_strain = 4e-4;               ///< platen displacement over height at which the run ends [-], > 0
  std::optional<double> stop_drop;  ///< the run ends below this share of the peak stress [-], in (0, 1)
  bool separation = false;          ///< the specimen may separate from the platens; needs moving points

  // Without platens (Direction::none):
  double initial_velocity_x = 0;  ///< of the whole specimen, to the right [m/s]
  double initial_velocity_y = 0;  ///< of the whole specimen, upwards [m/s]
  double duration = 0;            ///< time at which the run ends [s], > 0
};

/// Method for moving points.
struct Motion {
  Shape shape = Shape::gimp;
  Scheme scheme = Scheme::musl;
  Transfer transfer = Transfer::flip;
  double flip_ratio = 1;              ///< 1 = FLIP, 0 = PIC [-], in [0, 1]
  bool deformation_gradient = false;  ///< compute Result::deformation
  double margin = -1;  ///< width of the grid beyond closed and open edges [m]; < 0 = a quarter of the width
  Edge left = Edge::closed, right = Edge::closed;
  Edge bottom = Edge::closed, top = Edge::closed;  ///< only without platens
};

/// Limits at which Kinematics::automatic changes from small strain to moving points.
struct Handover {
  double strain = 0.01;        ///< largest principal strain of an intact point [-], > 0
  double displacement = 0.25;  ///< deviation of a node from the linear mean motion, in cells [-], > 0
};

/// Behaviour in compression of a point that failed in tension.
enum class CrackClosure {
  off,      ///< it carries no stress: a ghost point
  clipped,  ///< it carries its elastic stress with positive principal stresses set to zero; opening a crack
            ///< then relieves compression along it, and energy is not conserved (the ledger shows it)
  unilateral,  ///< the same, but without the effect of the opening on the stress along the crack (Poisson);
               ///< conserves energy
};

/// Random strengths, and what remains of a failed point.
struct Damage {
  std::uint64_t seed = 1;  ///< seed of the strength field
  CrackClosure crack_closure = CrackClosure::off;
  double residual_stiffness = 0;  ///< share of the stiffness that a failed point keeps [-], in [0, 1)
  double correlation_length = 0;  ///< of the strength field [m]; 0 = points are independent
};

/// How the state of a run follows from its loading.
enum class SolverMethod {
  explicit_,     ///< motion in small time steps, with inertia
  quasi_static,  ///< equilibrium at every strain, without waves
};

/// A run. Lengths from the lower left corner of the specimen; all quantities per metre of thickness.
struct Scene {
  PixelField<std::uint8_t> labels;           ///< label per pixel, shape (rows, cols), row 0 at the top
  double pixel_size = 0;                     ///< edge of a pixel [m], > 0
  std::vector<std::optional<Phase>> phases;  ///< by label; nullopt = void
  std::vector<ExtraPoint> extra_points;      ///< e.g. the ITZ as points

  Plane plane = Plane::strain;
  int points_per_cell = 2;  ///< along an edge of a cell: 1, 2, 3, 4; 2 means 2 x 2 points a cell
  /// One pixel is one cell with one state, integrated in full: it cracks through as a whole, and a layer is
  /// exact whatever its thickness. Needs points_per_cell = 1 and small strain.
  bool pixel_cells = false;
  SolverMethod method = SolverMethod::explicit_;
  /// Quasi-static: points that would fail up to this share above the strain of the next failure fail with it
  /// [-], in [0, 1); 0 = one failure at a time.
  double event_tolerance = 0.02;
  Kinematics kinematics = Kinematics::small_strain;
  Motion motion;
  Handover handover;
  Loading loading;
  Fixture fixture;  ///< supports, loads and gauges, in place of platens or beside them
  Damage damage;
  double local_damping = 0;  ///< share of the unbalanced force that opposes the motion [-], in [0, 1)
  double cfl =
      0.5;  ///< CFL number: time step over the time of the fastest wave through a cell [-], in (0, 1]
  Precision precision = Precision::double_;
  int threads = 0;  ///< do not change the result; 0 = chosen by the amount of work and the idle cores
  std::string instruction_set;  ///< of the kernels: baseline, avx2, avx512; empty = the fastest available
  int history_rows = 1000;      ///< rows of the history up to stop_strain, >= 10
  int frames = 0;               ///< frames up to stop_strain, for RunHooks::frames; 0 = none

  [[nodiscard]] double width() const { return static_cast<double>(labels.cols()) * pixel_size; }   ///< [m]
  [[nodiscard]] double height() const { return static_cast<double>(labels.rows()) * pixel_size; }  ///< [m]
};

/// @throws Error naming the first value that is out of range.
void validate(const Scene& scene);

/// Number of material points: pixels and extra points of solid phases.   @pre the scene is valid.
[[nodiscard]] std::int64_t count_points(const Scene& scene);

}  // namespace mpm
