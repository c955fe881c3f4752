/// A calibration, as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

namespace binding {

/// calibrate and the class Calibration.
void bind_fit(pybind11::module_& module);

}  // namespace binding
