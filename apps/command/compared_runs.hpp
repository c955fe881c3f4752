/// Several runs that were named on the command line, for what lays them over each other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/comparison.hpp"

namespace app {

/// The result of a run that was named by its folder, or by the file itself.
/// @throws Rejected (Exit::usage) for anything else.
[[nodiscard]] std::filesystem::path result_of(const std::string& run);

/// With the names of their folders, or the whole paths where these are not enough to tell them apart.
/// @throws Rejected (Exit::usage) for more than can be compared and for one that is given twice, and the
/// errors of the readers.
[[nodiscard]] std::vector<output::ComparedRun> read_compared(const std::vector<std::string>& runs);

}  // namespace app
