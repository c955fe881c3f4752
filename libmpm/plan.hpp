/// What a run needs, decided once from its scene.
#pragma once

#include <cstdint>

#include "libmpm/kernels.hpp"
#include "libmpm/scene.hpp"

namespace mpm {

struct Plan {
  int cells_x = 0;                 ///< columns of cells
  int cells_y = 0;                 ///< rows of cells
  double cell_size = 0;            ///< [m]
  double dt = 0;                   ///< [s]
  double wave_speed = 0;           ///< of the fastest phase present [m/s]
  double ramp_time = 0;            ///< [s]
  std::int64_t steps = 0;          ///< to stop_strain
  std::int64_t steps_per_row = 0;  ///< between rows of the history
  kernels::Features features;      ///< what the sweeps are compiled with
  double poisson = 0;              ///< of all phases, when features.one_poisson_ratio
};

/// @throws Error for a scene that is not valid.
[[nodiscard]] Plan plan(const Scene& scene);

/// Velocity of the top platen over its full value at a time [-]: a smooth step without a jump in
/// acceleration.
[[nodiscard]] double ramp(const Plan& plan, double time);

}  // namespace mpm
