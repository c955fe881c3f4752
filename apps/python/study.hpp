/// Runs, studies, twins and calibrations, as Python holds them, and what a study is asked for.
#pragma once

#include <pybind11/pybind11.h>
#include <filesystem>
#include <memory>

#include "apps/study/study.hpp"

namespace binding {

namespace py = pybind11;

/// A study that is about to begin.
struct StudyWish {
  app::Study study;
  std::shared_ptr<void> given;  ///< a specimen that was written for it; gone again when nothing else keeps it
  void keep() const;            ///< the specimen stays
};

/// Arguments of mesopix.study.
struct StudyArguments {
  const py::object& input;
  const py::dict& settings;
  const py::dict& options;
  const py::dict&
      wanted;  ///< title, vary, seeds, seed_of, sampling, samples, sampling_seed; None = not given
};

/// The study of a study.toml; or that of a scene, a picture or a specimen, whose study.toml, scene.toml and
/// specimen.h5 are those of the folder.
/// @throws app::Rejected.
[[nodiscard]] StudyWish read_wish(const StudyArguments& arguments, const std::filesystem::path& folder);

/// simulate, read_result and the class Result.
void bind_run(py::module_& module);

/// study and the class Study.
void bind_study(py::module_& module);

/// twin and the class Twins.
void bind_twins(py::module_& module);

/// stiffness.
void bind_stiffness(py::module_& module);

/// calibrate and the class Calibration.
void bind_fit(py::module_& module);

}  // namespace binding
