/// Pictures that are arrays.
/// NumPy arrays that show memory of C++, without a copy.
#pragma once

#include <pybind11/numpy.h>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace binding {

/// @param image  labels or grey of shape (rows, cols), or RGB of shape (rows, cols, 3) and 8 bits; row 0 on
/// top.
/// @throws app::Rejected for another shape or type, and for values that are not finite.
[[nodiscard]] specimen::Picture picture_of(const pybind11::object& image);

/// SHA-256 of its pixels.
[[nodiscard]] std::string digest_of(const specimen::Picture& picture);

namespace py = pybind11;

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

[[nodiscard]] py::array view(const std::vector<double>& numbers, const py::object& owner);

/// A structured array with the columns of the history, by their names.
[[nodiscard]] py::array view(const std::vector<mpm::HistoryRow>& history, const py::object& owner);

}  // namespace binding
