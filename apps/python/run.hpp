/// A run, as Python holds it.
/// From the arguments of simulate to a run.
#pragma once

#include <pybind11/pybind11.h>
#include <filesystem>
#include <memory>
#include <string>

#include "apps/job/job.hpp"
#include "apps/report/run_record.hpp"
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

/// Arguments of mesopix.simulate beside what is broken.
struct Wanted {
  pybind11::dict settings;
  pybind11::dict options;
  pybind11::object output;  ///< folder, or None
  bool overwrite = false;
  bool estimate_error = false;
  pybind11::object tolerance;  ///< or None
  pybind11::object progress;   ///< callback, or None
};

/// Solve without the lock, and write the folder that was asked for.
/// @throws app::Rejected; raises Diverged and Interrupted with what was computed, and what the callback
/// raises.
[[nodiscard]] std::shared_ptr<Run> simulate(const pybind11::object& input, const Wanted& wanted);

/// Write a run folder.   @throws NotWritten.
void write_folder(const std::filesystem::path& folder, const Run& run);

}  // namespace binding
