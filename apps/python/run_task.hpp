/// From the arguments of simulate to a run.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "apps/python/run.hpp"

namespace binding {

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
void write(const std::filesystem::path& folder, const Run& run);

}  // namespace binding
