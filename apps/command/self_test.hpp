/// Two runs with known answers, in two seconds.
#pragma once

namespace app {

struct SelfTest {
  static constexpr double allowed_modulus_error = 2e-3, allowed_peak_error = 1e-3;

  double modulus_error = 0;  ///< of a block without cracks over E / (1 - nu^2) [-]
  double peak_error = 0;     ///< of the peak stress of a block with aggregates that cracks, over the one that
                             ///< it had where the program was made [-]
  bool same_on_threads = false;   ///< that run has the same bits on one thread and on several
  int threads = 1;                ///< those
  double updates_per_second = 0;  ///< point-updates on one thread [1/s]
  double share_of_peak = 0;  ///< operations of them over what one core can do at most, measured just now [-]

  [[nodiscard]] bool is_right() const {
    return modulus_error < allowed_modulus_error && peak_error < allowed_peak_error && same_on_threads;
  }
};

/// @param threads  to compare with one, > 1 where there are as many cores.
[[nodiscard]] SelfTest run_self_test(int threads);

}  // namespace app
