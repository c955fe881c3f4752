/// The loop that drives a run.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "libmpm/frame.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene.hpp"

namespace mpm {

struct Plan;

/// What an observer is told at each history row.
struct Progress {
  const HistoryRow& row;
  double fraction = 0;   ///< of stop_strain that is done [-]
  double wall_time = 0;  ///< since the loop began [s]
  /// A copy of the result up to this row, maps and figures included; to be called while the observer is.
  std::function<Result()> so_far = {};
};

/// Returns false to end the run (StopReason::interrupted).
using Observer = std::function<bool(const Progress&)>;

/// Physics gone wrong: not a number, or an unstable step. The result up to there is kept.
struct Diverged : std::runtime_error {
  Diverged(const std::string& message, Result so_far)
      : std::runtime_error(message), result(std::move(so_far)) {}
  Result result;
};

/// Solve a scene.
/// @param frames  is lent Scene::frames of them, at rows of the history evenly spaced over the strain (over
/// the
///                time without platens), and before them the start; after a row that ends the run early its
///                own. They change nothing in the result. What it throws ends the run.
/// @throws Error for a scene that is not valid, Diverged with the step, time and place, and what to try.
[[nodiscard]] Result simulate(const Scene& scene, const Observer& observer = {},
                              const FrameSink& frames = {});

/// The same by a plan that may do more than the scene needs.
[[nodiscard]] Result simulate(const Scene& scene, const Plan& plan, const Observer& observer = {},
                              const FrameSink& frames = {});

}  // namespace mpm
