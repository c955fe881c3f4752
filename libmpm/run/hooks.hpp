/// Who looks on while a run goes, and what it throws when it goes wrong.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "libmpm/scene/result.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "libmpm/solver/frame.hpp"

namespace mpm {

/// What an observer is told at each history row.
struct Progress {
  const HistoryRow& row;
  double fraction = 0;   ///< of stop_strain that is done [-]
  double wall_time = 0;  ///< since the loop began, in all parts of the run [s]
  /// A copy of the result up to this row, maps and figures included; to be called while the observer is.
  std::function<Result()> so_far = {};
};

/// Returns false to end the run (StopReason::interrupted).
using Observer = std::function<bool(const Progress&)>;

/// Who looks on, each where they are wanted. They change nothing in the result, and what they throw ends the
/// run.
struct RunHooks {
  Observer observer = {};
  /// Is lent Scene::frames of them, at rows of the history evenly spaced over the strain (over the time
  /// without platens), and before them the start; after a row that ends the run early its own.
  FrameSink frames = {};
  CheckpointWish checkpoints = {};
};

/// Physics gone wrong: not a number, or an unstable step. The result up to there is kept.
struct Diverged : std::runtime_error {
  Diverged(const std::string& message, Result so_far)
      : std::runtime_error(message), result(std::move(so_far)) {}
  Result result;
};

}  // namespace mpm
