/// A run that a person looks on at: with a progress line, and ended in order by Ctrl-C.
#pragma once

#include <string>

#include "apps/console.hpp"
#include "apps/error_estimation.hpp"
#include "apps/interrupt.hpp"
#include "libmpm/simulate.hpp"

namespace app {

/// What a run ended with, kept whether it came to its end or not.
struct Outcome {
  mpm::Result result;
  std::string divergence;  ///< what went wrong; empty when nothing did

  [[nodiscard]] bool interrupted() const {
    return divergence.empty() && result.stop == mpm::StopReason::interrupted;
  }
};

/// @param hooks  their observer, where there is one, is asked beside the guard.
/// @param from  where the run goes on; none = from its start.
[[nodiscard]] Outcome solve(const mpm::Scene& scene, Console& console, const InterruptGuard& guard,
                            mpm::RunHooks hooks = {}, const mpm::Checkpoint* from = nullptr);

/// A second run that was interrupted, or went wrong.
struct NoEstimate {
  bool interrupted = false;
  std::string why;
};

/// Nothing is kept of second runs but what they end with; they throw NoEstimate. All must outlive it.
[[nodiscard]] Solve second_run(Console& console, const InterruptGuard& guard);

}  // namespace app
