/// In which folder a run is written.
#pragma once

#include <filesystem>

namespace app {

/// Creates the folder of a run: `wanted`, or runs/STEM, runs/STEM-2, ... when it is empty.
/// @throws Rejected (Exit::usage) when `wanted` is taken and may not be overwritten, (Exit::io) when it
/// cannot be made.
[[nodiscard]] std::filesystem::path make_run_folder(const std::filesystem::path& wanted,
                                                    const std::filesystem::path& stem, bool overwrite);

}  // namespace app
