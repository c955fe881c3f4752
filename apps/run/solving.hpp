/// Solving with a progress line and Ctrl-C, second runs for estimates of the error, remarks on the outcome.
#pragma once

#include <string>
#include <vector>

#include "apps/job/job.hpp"
#include "apps/run/error_estimation.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"
#include "libmpm/run/simulate.hpp"

namespace app {

/// What a run ended with, kept whether it came to its end or not.
struct Outcome {
  mpm::Result result;
  std::string divergence;  ///< what went wrong; empty when nothing did

  [[nodiscard]] bool interrupted() const {
    return divergence.empty() && result.stop == mpm::StopReason::interrupted;
  }
};

/// @param from  where the run goes on; none = from its start.
[[nodiscard]] Outcome solve(const mpm::Scene& scene, const mpm::RunHooks& hooks,
                            const mpm::Checkpoint* from = nullptr);

/// The same with a progress line, and ended in order by Ctrl-C.
/// @param hooks  their observer, where there is one, is asked beside the guard.
[[nodiscard]] Outcome solve(const mpm::Scene& scene, Console& console, const InterruptGuard& guard,
                            mpm::RunHooks hooks = {}, const mpm::Checkpoint* from = nullptr);

/// A second run that was interrupted, or went wrong.
struct NoEstimate {
  bool interrupted = false;
  std::string why;
};

/// Nothing is kept of a second run but what it ends with.   @throws NoEstimate.
[[nodiscard]] mpm::Result end_of_second_run(Outcome outcome);

/// Second runs of a person who looks on. All must outlive it.
[[nodiscard]] Solve second_run(Console& console, const InterruptGuard& guard);

/// How wrong the peak of a run that came to its end may be; without sources where a second run did not, or
/// where it reached no peak, which is noted.
[[nodiscard]] output::ErrorEstimate estimate_of(const Outcome& outcome, Job& job, const Solve& second);

/// The estimate that a tolerance has led to; without sources, which is noted, for a run that reached no peak
/// of which it could be the error.
[[nodiscard]] output::ErrorEstimate of_a_peak(output::ErrorEstimate estimate, const Outcome& outcome,
                                              Job& job);

/// @param option  that asked for it, as the caller names it.   @throws Rejected (Exit::data) for a tolerance
/// that was not met, with the error that is left.
void require_met(const Tolerated& found, double tolerance, const std::string& option);

/// Gives the job the rate, step and precision that were found for a tolerance.
void adopt(const Tolerated& found, Job& job);

/// A sentence about a run.
struct Remark {
  std::string text;
  const char* kind = "";  ///< "note" or "warning"; empty where an error says it
};

/// What the run itself leaves to be noted.
[[nodiscard]] std::vector<Remark> remarks_on(const Outcome& outcome, const mpm::Scene& scene);

}  // namespace app
