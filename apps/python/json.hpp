/// JSON as dictionaries and lists of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>

namespace binding {

template <class Json>
[[nodiscard]] pybind11::object as_dict(const Json& json) {
  return pybind11::module_::import("json").attr("loads")(
      json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace binding
