/// A run, as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

#include "apps/job/job.hpp"
#include "apps/report/error_estimate.hpp"
#include "libmpm/scene/result.hpp"

namespace binding {

/// mesopix.Result: owner of all that its arrays show.
struct Run {
  app::Job job;
  mpm::Result result;
  output::ErrorEstimate estimate = {};
  bool is_given = false;  ///< the specimen is no file, and is written beside the result

  /// The resolved scene, as a folder would keep it.
  [[nodiscard]] std::string scene_toml(const std::filesystem::path& folder) const;
};

/// simulate, read_result and the classes Result and Progress.
void bind_run(pybind11::module_& module);

}  // namespace binding
