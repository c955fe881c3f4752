/// What this machine is and can do, measured, and how much of it a run may take.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace app {

struct Machine {
  std::string processor;                      ///< as it calls itself; empty = it does not
  int cores = 1;                              ///< that this program may use
  int idle_cores = 1;                         ///< of them, that nothing else uses at this moment
  double quota = 0;                           ///< cores' worth of time that the container has; 0 = no limit
  std::vector<std::string> instruction_sets;  ///< that the solver has for it, fastest first
  std::uint64_t memory = 0;                   ///< [bytes]
  std::uint64_t free_memory = 0;              ///< that could be had without swapping [bytes]
  std::uint64_t memory_limit = 0;             ///< that the program keeps to [bytes]; 0 = none
};

[[nodiscard]] Machine this_machine();

/// Cores' worth of time of the file cpu.max of a control group: 1.5 of "150000 100000"; 0 of "max 100000".
[[nodiscard]] double quota_of(const std::string& cpu_max);

/// Free for this user where a folder is [bytes].   @throws Rejected (Exit::io).
[[nodiscard]] std::uint64_t free_disk(const std::string& folder);

/// Whether a file can be written there: empty, or why not.
[[nodiscard]] std::string why_not_writable(const std::string& folder);

struct MachinePeak {
  double flops_double = 0;    ///< multiply-adds in 64 bits, two operations each, one core [1/s]
  double flops_single = 0;    ///< the same in 32 bits [1/s]
  double copy_bandwidth = 0;  ///< bytes read plus bytes written of a copy that fits no cache, one core [B/s]
};

/// Takes about half a second, and half a GB of memory for that time.
[[nodiscard]] MachinePeak measure_machine_peak();

/// MachinePeak::flops_double alone; takes a tenth of a second and no memory.
[[nodiscard]] double measure_flops_double();

/// Additions and multiplications of one point-update of the small-strain solver with one Poisson ratio: 40 at
/// the point (strain, stress, both failure tests, forces) and a quarter of a node's 14.
inline constexpr double lattice_operations = 43.5;

}  // namespace app
