/// What this machine can do at most, measured: the yardstick beside every speed that is quoted.
#pragma once

namespace app {

struct MachinePeak {
  double flops_double = 0;    ///< multiply-adds in 64 bits, two operations each, one core [1/s]
  double flops_single = 0;    ///< the same in 32 bits [1/s]
  double copy_bandwidth = 0;  ///< bytes read plus bytes written of a copy that fits no cache, one core [B/s]
};

/// Takes about half a second, and half a GB of memory for that time.
[[nodiscard]] MachinePeak measure_machine_peak();

/// MachinePeak::flops_double alone; takes a tenth of a second and no memory.
[[nodiscard]] double measure_flops_double();

/// Additions and multiplications of one point-update of the small-strain solver with one Poisson ratio: 43 at
/// the point (strain, stress, both failure tests, forces) and a quarter of a node's 14.
inline constexpr double lattice_operations = 46.5;

}  // namespace app
