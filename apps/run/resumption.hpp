/// What a run that was stopped goes on from.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "apps/settings/assignment.hpp"
#include "apps/system/console.hpp"
#include "apps/run/run_task.hpp"

namespace app {

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
