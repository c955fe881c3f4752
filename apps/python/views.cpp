#include "apps/python/views.hpp"

#include <string>
#include <variant>

#include "libmpm/scene/history_columns.hpp"

namespace binding {
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

}  // namespace

py::array frozen_view(const py::dtype& type, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                      const void* data, const py::object& owner) {
  py::array array(type, std::move(shape), std::move(strides), data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array view(const std::vector<double>& numbers, const py::object& owner) {
  return frozen_view(py::dtype::of<double>(), {static_cast<py::ssize_t>(numbers.size())}, {sizeof(double)},
                     numbers.data(), owner);
}

py::array view(const std::vector<mpm::HistoryRow>& history, const py::object& owner) {
  return frozen_view(history_type(), {static_cast<py::ssize_t>(history.size())}, {sizeof(mpm::HistoryRow)},
                     history.data(), owner);
}

}  // namespace binding
