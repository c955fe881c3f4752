/// Settings as Python writes them.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "apps/settings/assignment.hpp"
#include "apps/settings/offer.hpp"

namespace binding {

namespace py = pybind11;

/// Settings by key or short name, of a dictionary and of keyword arguments.
///
/// Numbers are in SI units (angles in rad); texts are read as the program reads its options, "0.5 mm". Lists
/// may be any sequences, and tables of labels dictionaries, {0: "void", 1: "mortar"}.
/// @throws app::Rejected with every name that is not offered or given twice, and every value of a wrong type.
[[nodiscard]] std::vector<app::Assignment> assignments(const app::Offer& offer, const py::dict& settings,
                                                       const py::dict& options);

/// A value of a setting.   @throws app::Mistake for what is no value at all.
[[nodiscard]] app::Value value_of(const app::Field& field, py::handle value);

/// An option beside the settings, as the text that the program would get: numbers in SI units.
/// @param unit  of numbers, "Pa"; empty = none.
[[nodiscard]] std::string option_text(const py::object& value, const char* unit = "");

/// (name, key, type, default, help) of every setting that an offer has a short name for, in the order of the
/// schema; those of phases are "PHASE.young".
[[nodiscard]] py::list described(const app::Offer& offer);

/// The text of a path: str or os.PathLike.   @throws TypeError.
[[nodiscard]] std::string path_text(const py::object& path);

}  // namespace binding
