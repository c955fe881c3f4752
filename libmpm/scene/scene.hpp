/// A scene: plain data that says everything about a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/phase.hpp"

namespace mpm {

enum class Direction {
  tension,
  compression,
  none,  ///< no platens: the specimen flies with Loading::initial_velocity; for moving points
};

/// How a platen holds the specimen sideways: smooth = free (one node pinned), rough = no sideways motion.
enum class Platen { smooth, rough };

enum class Precision {
  single,   ///< stresses in 32 bits, motion of the nodes in 64 bits
  double_,  ///< 64 bits throughout
};

/// How points follow the motion.
enum class Kinematics {
  small_strain,  ///< points keep their place in the picture; stress follows from the displacement of the
                 ///< nodes
  moving,        ///< points move through the grid and carry their velocity and stress
  automatic,     ///< small strain until Handover says that it ends, then moving
};

/// Shape functions of moving points.
enum class Shape {
  linear,   ///< tent of a cell's width; Sulsky, Chen, Schreyer (1994)
  gimp,     ///< uniform generalised interpolation; Bardenhagen, Kober (2004)
  bspline,  ///< quadratic B-spline; Steffen, Kirby, Berzins (2008)
};

/// When in a step the stress follows the motion of the nodes.
enum class Scheme {
  usf,   ///< first, from the momentum that the points brought
  usl,   ///< last, from the velocity at the end of the step; with APIC the same as musl
  musl,  ///< last, from the new velocity of the points, mapped back; Sulsky, Zhou, Schreyer (1995)
};

/// How the velocity of the nodes comes back to the points.
enum class Transfer {
  flip,  ///< its change is added; Motion::flip_ratio blends with its value (PIC)
  apic,  ///< its value and its gradient are taken; Jiang, Schroeder, Selle, Teran, Stomakhin (2015)
};

/// What stands at an edge of the grid of moving points.
enum class Edge {
  closed,       ///< nothing; a point that leaves there is an error
  open,         ///< nothing; points that leave there are taken out and counted
  symmetry,     ///< plane of symmetry: no motion across it
  smooth_wall,  ///< wall without friction, from which the specimen may part
  rough_wall,   ///< wall to which what touches it sticks, from which the specimen may part
};

/// A material point beside those of the pixels; shares the volume of its pixel with the points that lie in
/// it.
struct ExtraPoint {
  double x = 0;            ///< [m]
  double y = 0;            ///< [m]
  std::uint8_t phase = 0;  ///< label
};

struct Loading {
  Direction direction = Direction::tension;
  double velocity = 0.05;  ///< of the top platen, its amount [m/s], > 0
  double ramp_time = -1;   ///< from rest to full velocity [s]; < 0 = two transits of the slowest wave
  Platen platen = Platen::smooth;
  double stop_strain = 4e-4;        ///< platen displacement over height at which the run ends [-], > 0
  std::optional<double> stop_drop;  ///< ends below this share of the peak stress [-], in (0, 1)
  bool separation = false;          ///< the specimen may part from the platens; for moving points

  // Without platens (Direction::none):
  double initial_velocity_x = 0;  ///< of the whole specimen [m/s]
  double initial_velocity_y = 0;  ///< [m/s], upwards
  double duration = 0;            ///< time at which the run ends [s], > 0
};

/// How moving points are solved for.
struct Motion {
  Shape shape = Shape::gimp;
  Scheme scheme = Scheme::musl;
  Transfer transfer = Transfer::flip;
  double flip_ratio = 1;              ///< 1 = FLIP, 0 = PIC [-], in [0, 1]
  bool deformation_gradient = false;  ///< the result has that of every point
  double margin = -1;  ///< of the grid beyond edges that are closed or open [m]; < 0 = a quarter of the width
  Edge left = Edge::closed, right = Edge::closed;
  Edge bottom = Edge::closed, top = Edge::closed;  ///< without platens
};

/// When Kinematics::automatic goes over from small strain to moving points.
struct Handover {
  double strain = 0.01;        ///< largest principal strain of a live point [-], > 0
  double displacement = 0.25;  ///< of a node from the mean motion between the platens, in cells [-], > 0
};

/// What a point that failed in tension does when it is compressed.
enum class CrackClosure {
  off,         ///< nothing: it is a ghost point
  clipped,     ///< it carries its elastic stress with positive principal stresses clipped to zero; opening a
               ///< crack then relieves compression along it, and energy is not kept (the ledger shows it)
  unilateral,  ///< the same without what Poisson's effect of the opening did to the stress along the crack;
               ///< keeps energy
};

struct Damage {
  std::uint64_t seed = 1;  ///< of the strength field
  CrackClosure crack_closure = CrackClosure::off;
  double residual_stiffness = 0;  ///< share of the stiffness that a failed point keeps [-], in [0, 1)
  double correlation_length = 0;  ///< of the strength field [m]; 0 = every point is drawn on its own
};

struct Scene {
  PixelField<std::uint8_t> labels;           ///< label per pixel, row 0 on top
  double pixel_size = 0;                     ///< [m], > 0
  std::vector<std::optional<Phase>> phases;  ///< by label; nullopt = void
  std::vector<ExtraPoint> extra_points;

  Plane plane = Plane::strain;
  int points_per_cell = 2;  ///< along an edge of a cell: 1, 2, 3, 4; 2 means 2 x 2 points a cell
  Kinematics kinematics = Kinematics::small_strain;
  Motion motion;
  Handover handover;
  Loading loading;
  Damage damage;
  double local_damping = 0;  ///< share of the unbalanced force that opposes the motion [-], in [0, 1)
  double cfl = 0.5;          ///< time step over cell size by fastest wave speed [-], in (0, 1]
  Precision precision = Precision::double_;
  int threads = 0;  ///< does not change the result; 0 = as many as have enough to do and a core to do it
  std::string
      instruction_set;  ///< of the sweeps: baseline, avx2, avx512; empty = the fastest that the processor has
  int history_rows = 1000;  ///< rows of the history up to stop_strain, >= 10
  int frames = 0;           ///< of the points up to stop_strain, for who asks simulate() for them; 0 = none

  [[nodiscard]] double width() const { return static_cast<double>(labels.cols()) * pixel_size; }   ///< [m]
  [[nodiscard]] double height() const { return static_cast<double>(labels.rows()) * pixel_size; }  ///< [m]
};

/// @throws Error naming the first value that is out of range.
void validate(const Scene& scene);

/// Material points of a valid scene: its pixels and extra points of solid phases.
[[nodiscard]] std::int64_t count_points(const Scene& scene);

}  // namespace mpm
