/// What this machine can do at most, measured: the yardstick beside every speed that is quoted.
#pragma once

namespace bench {

struct MachinePeak {
  double flops_double = 0;    ///< multiply-adds in 64 bits, two operations each, one core [1/s]
  double flops_single = 0;    ///< the same in 32 bits [1/s]
  double copy_bandwidth = 0;  ///< bytes read plus bytes written of a copy that fits no cache, one core [B/s]
};

/// Takes about half a second.
[[nodiscard]] MachinePeak measure_machine_peak();

}  // namespace bench
