/// What a callback is told.
#pragma once

#include <pybind11/pybind11.h>

#include "apps/calibrate/calibration.hpp"
#include "apps/study/study_run.hpp"
#include "libmpm/run/simulate.hpp"

namespace binding {

/// mesopix.Progress of a run.
[[nodiscard]] pybind11::object glance_at(const mpm::Progress& progress);

/// mesopix.Trial of a calibration.   @pre it has a history.
[[nodiscard]] pybind11::object glance_at(const app::Calibration& so_far);

/// mesopix.StudyProgress.
[[nodiscard]] pybind11::object glance_at(const app::StudyTally& tally);

/// mesopix.TwinProgress.
[[nodiscard]] pybind11::object glance_at_twins(std::size_t done, int count);

}  // namespace binding
