/// A run folder, read back.
#pragma once

#include <filesystem>

#include "apps/run/run_folder.hpp"
#include "apps/settings/settings.hpp"

namespace app {

/// Owner of what a RunRecord refers to.
struct ReadRun {
  specimen::Specimen specimen;
  mpm::Scene scene;
  mpm::Result result;
  std::string scene_toml;
  Settings settings;  ///< of the scene, paths in it relative to where the program is

  [[nodiscard]] RunRecord record() const;
};

/// Specimen, scene and result of a run.
/// @throws Rejected (Exit::usage) for what is no run folder, (Exit::data) for one whose files do not belong
/// together, and the errors of the readers.
[[nodiscard]] ReadRun read_run(const std::string& folder);

}  // namespace app
