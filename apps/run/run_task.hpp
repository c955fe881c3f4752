/// A run, from its job to its folder.
/// What a run that was stopped goes on from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/job/job.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"
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

/// The task of the run in a folder, from its last checkpoint that can be read; what is wrong with those
/// behind it is said. Nothing when the run has come to its end, which is said too.
/// @param given  settings beside it: they must be those of the run, but for solver.threads.
/// @throws Rejected for a folder without a checkpoint, and for a scene or a specimen that is not that of the
/// run any
///         more, naming what differs.
[[nodiscard]] std::optional<RunTask> task_that_goes_on(const std::filesystem::path& folder,
                                                       const std::vector<Assignment>& given,
                                                       Console& console);

}  // namespace app
