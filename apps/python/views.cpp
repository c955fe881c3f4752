#include "apps/python/views.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <variant>

#include "apps/text/complaint.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/files.hpp"

namespace binding {
namespace {

[[noreturn]] void refuse(const std::string& value, const char* allowed, const char* cure = "") {
  throw app::Rejected(app::Exit::data, "image", value, allowed, cure);
}

std::string shape_text(const py::array& image) {
  return fmt::format("{} of shape {}", py::str(image.dtype()).cast<std::string>(),
                     py::str(image.attr("shape")).cast<std::string>());
}

template <class T>
specimen::Raster<T> raster_of(const void* values, py::ssize_t rows, py::ssize_t cols) {
  specimen::Raster<T> raster(static_cast<int>(rows), static_cast<int>(cols));
  std::memcpy(raster.data.data(), values, raster.size() * sizeof(T));
  return raster;
}

bool is_plain_number(const py::array& image) {
  return std::string_view("buif").find(image.dtype().kind()) != std::string_view::npos;
}

}  // namespace

specimen::Picture picture_of(const py::object& object) {
  static_assert(sizeof(specimen::Rgb) == 3);
  const py::array image = py::array::ensure(object);
  if (!image) throw py::error_already_set();
  const bool colour =
      image.ndim() == 3 && image.shape(2) == 3 && py::isinstance<py::array_t<std::uint8_t>>(image);
  if (!is_plain_number(image) || (image.ndim() != 2 && !colour))
    refuse(shape_text(image),
           "must be labels or grey of shape (rows, columns), or uint8 of shape (rows, columns, 3)",
           image.ndim() == 3 && image.shape(2) == 4 ? "image[..., :3] leaves the transparency out" : "");
  if (image.size() == 0 || image.size() > 600'000'000)
    refuse(shape_text(image), "must have between 1 and 200 million pixels");
  specimen::Picture picture;
  if (colour) {
    const auto values = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>(image);
    picture.colour = raster_of<specimen::Rgb>(values.data(), image.shape(0), image.shape(1));
    return picture;
  }
  const auto values = py::array_t<double, py::array::c_style | py::array::forcecast>(image);
  auto gray = raster_of<double>(values.data(), image.shape(0), image.shape(1));
  picture.bits = static_cast<int>(8 * image.itemsize());
  const bool finite =
      std::all_of(gray.data.begin(), gray.data.end(), [](double v) { return std::isfinite(v); });
  picture.gray = std::move(gray);
  if (!finite)
    refuse("a value that is not finite", "must be numbers throughout",
           "numpy.nan_to_num puts others in their place");
  return picture;
}

std::string digest_of(const specimen::Picture& picture) {
  const auto bytes = [](const auto& raster) {
    return std::string_view(reinterpret_cast<const char*>(raster.data.data()),
                            raster.size() * sizeof(raster.data.front()));
  };
  return specimen::sha256_of_text(picture.gray.empty() ? bytes(picture.colour)
                                                       : bytes(picture.gray.doubles()));
}

namespace {

/// Where a member lies in a row.
template <class T>
py::ssize_t offset_of(T mpm::HistoryRow::*member) {
  static const mpm::HistoryRow row;
  return reinterpret_cast<const char*>(&(row.*member)) - reinterpret_cast<const char*>(&row);
}

template <class T>
py::dtype type_of(T mpm::HistoryRow::*) {
  return py::dtype::of<T>();
}

}  // namespace

py::dtype history_type() {
  py::list names, formats, offsets;
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    names.append(std::string(column.name));
    std::visit(
        [&](const auto& member) {
          formats.append(type_of(member));
          offsets.append(offset_of(member));
        },
        column.member);
  }
  return {std::move(names), std::move(formats), std::move(offsets), sizeof(mpm::HistoryRow)};
}

py::array frozen_view(const py::dtype& type, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                      const void* data, const py::object& owner) {
  py::array array(type, std::move(shape), std::move(strides), data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::object curve_of(const py::object& strain, const py::object& stress) {
  return py::module_::import("mesopix.results").attr("Curve")(strain, stress);
}

}  // namespace binding
