/// Studies and twins, as Python holds them.
#pragma once

#include <pybind11/pybind11.h>

namespace binding {

/// study and the class Study.
void bind_study(pybind11::module_& module);

/// twin and the class Twins.
void bind_twins(pybind11::module_& module);

}  // namespace binding
