/// A specimen, as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/job/specimen_source.hpp"
#include "apps/scene/scene_file.hpp"
#include "specimen/body/specimen.hpp"

namespace binding {

namespace py = pybind11;

/// mesopix.Specimen
struct Body {
  std::shared_ptr<const specimen::Specimen> specimen;
  std::vector<std::string> notes;  ///< what was guessed when it was made, one sentence each
};

/// generate, convert, read_specimen and the class.
void bind_specimen(py::module_& module);

/// What is broken: a Specimen, or what a path says.
struct Broken {
  app::Resolved resolved;
  std::optional<app::Prepared> given;  ///< the specimen, where it is none that is still to be made
  std::string stem;                    ///< of the path; "specimen" where there is none

  /// Make the specimen, or take the given one, in whole cells.   @pre called with the lock.
  [[nodiscard]] app::Prepared cells() const;
  /// The same as it is.
  [[nodiscard]] app::Prepared whole() const;
};

/// @param argument  what the program calls a path there: "INPUT", "PICTURE"; a "SCENE" is no other file.
/// @throws app::Rejected.
[[nodiscard]] Broken broken_of(const py::object& input, std::vector<app::Assignment> given,
                               const std::string& argument);

/// Where a specimen that is no file is written beside what came of it.
inline constexpr const char* specimen_name = "specimen.h5";

}  // namespace binding
