/// A run folder, read back.
#pragma once

#include <filesystem>

#include "apps/run_folder.hpp"

namespace app {

/// Owner of what a RunRecord refers to.
struct ReadRun {
  specimen::Specimen specimen;
  mpm::Scene scene;
  mpm::Result result;
  std::string scene_toml;
  std::string title;

  [[nodiscard]] RunRecord record() const;
};

/// Specimen, scene and result of a run.
/// @throws Rejected (Exit::usage) for what is no run folder, (Exit::data) for one whose files do not belong
/// together, and the errors of the readers.
[[nodiscard]] ReadRun read_run(const std::string& folder);

}  // namespace app
