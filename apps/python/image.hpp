/// Pictures that are arrays.
#pragma once

#include <pybind11/numpy.h>

#include "specimen/picture/picture.hpp"

namespace binding {

/// @param image  labels or grey of shape (rows, cols), or RGB of shape (rows, cols, 3) and 8 bits; row 0 on
/// top.
/// @throws app::Rejected for another shape or type, and for values that are not finite.
[[nodiscard]] specimen::Picture picture_of(const pybind11::object& image);

/// SHA-256 of its pixels.
[[nodiscard]] std::string digest_of(const specimen::Picture& picture);

}  // namespace binding
