/// Callbacks of a run, and the exception for a run that becomes unstable.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "libmpm/scene/result.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "libmpm/solver/frame.hpp"

namespace mpm {

/// State of the run at a row of the history, for an observer.
struct Progress {
  const HistoryRow& row;
  double fraction = 0;   ///< share of the run that is done [-]
  double wall_time = 0;  ///< of the time loop so far, over all resumed parts [s]
  /// Makes a copy of the result up to this row, including maps; valid only while the observer runs.
  std::function<Result()> so_far = {};
};

/// Called at each row of the history; returns false to end the run (StopReason::interrupted).
using Observer = std::function<bool(const Progress&)>;

/// Callbacks of a run; each may be empty. They do not change the result. An exception from one ends the run
/// and is passed on.
struct RunHooks {
  Observer observer = {};
  /// Called with the initial state, then with Scene::frames frames at rows of the history that are evenly
  /// spaced over the strain (without platens over the time). Where stop_strain lies far beyond any peak there
  /// are more of them, closer below it, so that a run that ends at a drop of the stress shows its failure.
  /// The last frame is the final state.
  FrameSink frames = {};
  CheckpointWish checkpoints = {};
};

/// The run became unstable: a value is not a number, or energy grows without work. what() names the step, the
/// time, the worst point and a safe CFL number.
struct Diverged : std::runtime_error {
  Diverged(const std::string& message, Result so_far)
      : std::runtime_error(message), result(std::move(so_far)) {}
  Result result;  ///< up to the instability
};

}  // namespace mpm
