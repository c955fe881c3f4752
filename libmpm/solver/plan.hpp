/// What a run needs, decided once from its scene.
#pragma once

#include <cstdint>

#include "libmpm/kernels/lattice_kernels.hpp"
#include "libmpm/kernels/moving_kernels.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// What moving points need beside that.
struct MovingPlan {
  moving::Features features;        ///< what their sweeps are compiled with
  moving::OptionalFields optional;  ///< numbers of a point that this run carries
  bool mapped_back = true;  ///< the new momentum goes to the nodes once more (MUSL, and USL with APIC)
  double half_size = 0.5;   ///< of a point, over the size of a cell [-]
  double crack_band = 0;    ///< width over which a crack is smeared [m]
  int margin_left = 0, margin_right = 0, margin_bottom = 0, margin_top = 0;  ///< cells beyond the picture
};

struct Plan {
  int cells_x = 0;                 ///< columns of cells
  int cells_y = 0;                 ///< rows of cells
  double cell_size = 0;            ///< [m]
  double dt = 0;                   ///< [s]
  double wave_speed = 0;           ///< of the fastest phase present [m/s]
  double ramp_time = 0;            ///< [s]
  int threads = 1;                 ///< that share the rows
  std::int64_t steps = 0;          ///< to stop_strain or the end of the duration, with this time step
  std::int64_t steps_per_row = 0;  ///< between rows of the history
  kernels::Features features;      ///< what the sweeps are compiled with
  bool softens = false;            ///< some point has a fracture energy
  double poisson = 0;              ///< of all phases, when features.one_poisson_ratio
  MovingPlan moving;               ///< unless the kinematics are those of small strain
};

/// @throws Error for a scene that is not valid.
[[nodiscard]] Plan plan(const Scene& scene);

/// Share of the time step that local damping leaves [-]: where the motion slows down, the damping force adds
/// to the force that slows it, as if the specimen were stiffer by the factor 1 + local_damping.
[[nodiscard]] double damped_share(double local_damping);

/// Velocity of the top platen over its full value at a time [-]: a smooth step without a jump in
/// acceleration.
[[nodiscard]] double ramp(const Plan& plan, double time);

}  // namespace mpm
