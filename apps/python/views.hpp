/// NumPy arrays as pictures, and such that show memory of C++ without a copy.
#pragma once

#include <pybind11/numpy.h>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace binding {

namespace py = pybind11;

/// @param image  labels or grey of shape (rows, cols), or RGB of shape (rows, cols, 3) and 8 bits; row 0 on
/// top.
/// @throws app::Rejected for another shape or type, and for values that are not finite.
[[nodiscard]] specimen::Picture picture_of(const py::object& image);

/// SHA-256 of its pixels.
[[nodiscard]] std::string digest_of(const specimen::Picture& picture);

/// Of memory that `owner` keeps; the array keeps the owner alive, and is read-only.
[[nodiscard]] py::array frozen_view(const py::dtype& type, std::vector<py::ssize_t> shape,
                                    std::vector<py::ssize_t> strides, const void* data,
                                    const py::object& owner);

/// Shape (rows, cols), row 0 on top.
template <class T>
[[nodiscard]] py::array view(const specimen::Raster<T>& raster, const py::object& owner) {
  constexpr auto size = static_cast<py::ssize_t>(sizeof(T));
  return frozen_view(py::dtype::of<T>(), {raster.rows, raster.cols}, {raster.cols * size, size},
                     raster.data.data(), owner);
}

/// The same; None for a lattice that is empty.
template <class T>
[[nodiscard]] py::object view(const mpm::PixelField<T>& lattice, const py::object& owner) {
  constexpr auto size = static_cast<py::ssize_t>(sizeof(T));
  if (lattice.size() == 0) return py::none();
  return frozen_view(py::dtype::of<T>(), {lattice.rows(), lattice.cols()}, {lattice.cols() * size, size},
                     lattice.data(), owner);
}

/// Shape (values).
template <class T>
[[nodiscard]] py::array view(const std::vector<T>& values, const py::object& owner,
                             const py::dtype& type = py::dtype::of<T>()) {
  return frozen_view(type, {static_cast<py::ssize_t>(values.size())}, {sizeof(T)}, values.data(), owner);
}

/// Of a row of the history: its columns by their names.
[[nodiscard]] py::dtype history_type();

/// mesopix.Curve: strain [-] and stress [Pa].
[[nodiscard]] py::object curve_of(const py::object& strain, const py::object& stress);

}  // namespace binding
