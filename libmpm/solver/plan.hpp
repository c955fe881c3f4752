/// The plan of a run: everything that follows from its scene before the time loop:
/// cells, time step, ramp, threads, features.
#pragma once

#include <cstdint>

#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/kernels/moving_kernels.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/boundary.hpp"

namespace mpm {

/// Additional plan for moving points.
struct MovingPlan {
  moving::Features features;        ///< compile-time options of their sweeps
  moving::OptionalFields optional;  ///< optional fields of a point
  bool mapped_back = true;          ///< new momentum is mapped back to the nodes (MUSL, and USL with APIC)
  double half_size = 0.5;           ///< of a point, over the size of a cell [-]
  double crack_band = 0;            ///< width over which a crack is smeared [m]
  int margin_left = 0, margin_right = 0, margin_bottom = 0, margin_top = 0;  ///< cells beyond the picture
};

struct Plan {
  int cells_x = 0;                 ///< columns of cells
  int cells_y = 0;                 ///< rows of cells
  double cell_size = 0;            ///< [m]
  double dt = 0;                   ///< [s]
  double wave_speed = 0;           ///< of the fastest phase present [m/s]
  double transit_time = 0;         ///< of a wave along a bar, through the longer side of the specimen [s]
  double ramp_time = 0;            ///< [s]
  int threads = 1;                 ///< that share the rows
  std::int64_t steps = 0;          ///< to stop_strain or the end of the duration, with this time step
  std::int64_t steps_per_row = 0;  ///< between rows of the history
  kernels::Features features;      ///< compile-time options of the sweeps
  bool softens = false;            ///< some point has a fracture energy
  double poisson = 0;              ///< of all phases, when features.one_poisson_ratio
  GridBoundary boundary;           ///< supports, loads and gauges; empty between platens
  MovingPlan moving;               ///< unless the kinematics are those of small strain
};

/// @throws Error for an invalid scene.
[[nodiscard]] Plan plan(const Scene& scene);

/// Factor of local damping on the time step [-]: where the motion slows down, damping adds to the
/// decelerating force, as if the specimen were stiffer by the factor 1 + local_damping.
[[nodiscard]] double damped_share(double local_damping);

/// Velocity of the top platen over its full value at a time [-]: a smooth step without a jump in
/// acceleration.
[[nodiscard]] double ramp(const Plan& plan, double time);

}  // namespace mpm
