/// A run, from its job to its folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/text/complaint.hpp"
#include "apps/system/console.hpp"
#include "apps/system/interrupt.hpp"
#include "apps/job/job.hpp"
#include "apps/run/run_remarks.hpp"
#include "libmpm/solver/checkpoint.hpp"

namespace app {

struct RunTask {
  Job job;
  std::filesystem::path folder;         ///< exists
  std::string scene_toml;               ///< the resolved scene, as the folder keeps it
  RunRemarks remarks;                   ///< its notes are those of the job
  std::optional<mpm::Checkpoint> from;  ///< where an earlier part of the run ended; none = at the start
  std::optional<int> port;              ///< where it can be watched; 0 = any that is free, none = nowhere
  bool json = false;                    ///< the summary goes to standard output
};

/// Solve, and write what came of it; frames and checkpoints on the way. Checkpoints are removed once the run
/// has come to its end; one that is interrupted keeps them, and says how to go on.
/// @throws Rejected (Exit::data) when the physics went wrong, once all is written, (Exit::interrupted) while
/// another program writes the folder; mpm::FileError, specimen::Error.
[[nodiscard]] Exit carry_out(RunTask task, const InterruptGuard& guard, Console& console);

}  // namespace app
