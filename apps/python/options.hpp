/// Settings, JSON and exceptions as Python has them.
#pragma once

#include <pybind11/pybind11.h>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/settings/assignment.hpp"
#include "apps/settings/offer.hpp"

namespace binding {

namespace py = pybind11;

/// JSON as dictionaries and lists.
template <class Json>
[[nodiscard]] py::object as_dict(const Json& json) {
  return py::module_::import("json").attr("loads")(
      json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

/// Do the work; what it throws is located where the user set what it is about, and becomes app::Rejected.
/// Exceptions of Python pass, and so does a lack of memory.
template <class Work>
auto located(const app::Origins& origins, Work&& work) {
  try {
    return work();
  } catch (const py::error_already_set&) {
    throw;
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    throw app::refusal_of(std::current_exception(), app::located_by(origins));
  }
}

/// app::Rejected becomes mesopix.FileError (Exit::io), RuntimeError (Exit::internal), or else mesopix.Error.
void translate_refusals();

/// Raise mesopix.NAME(text, result): Diverged or Interrupted.
[[noreturn]] void raise_with(const char* name, const std::string& text, const py::object& result);

/// Raise what a refusal becomes, with what was computed as .result.
[[noreturn]] void raise_with(const app::Rejected& refusal, const py::object& result);

/// Say before a long call what it takes, as a mesopix.LongRun: nothing for an empty text.
/// @throws py::error_already_set where the caller has made warnings errors.
void warn_of_length(const std::string& text);

/// The same of what speaks against a specimen, a mesopix.Doubt each.
void warn_of_doubts(const std::vector<std::string>& doubts);

/// Where complaints about the option -o come from: an argument of that name.
[[nodiscard]] app::Origins with_output(const char* argument, app::Origins origins = {});

/// Settings by key or short name, of a dictionary and of keyword arguments.
///
/// Numbers are in SI units (angles in rad); texts are read as the program reads its options, "0.5 mm". Lists
/// may be any sequences, and tables of labels dictionaries, {0: "void", 1: "mortar"}.
/// @throws app::Rejected with every name that is not offered or given twice, and every value of a wrong type.
[[nodiscard]] std::vector<app::Assignment> assignments(const app::Offer& offer, const py::dict& settings,
                                                       const py::dict& options);

/// A value of a setting.   @throws app::Mistake for what is no value at all.
[[nodiscard]] app::Value value_of(const app::Field& field, py::handle value);

/// A value that is not one of a setting: texts as they are, anything that can be gone through as a list.
/// @throws app::Mistake for what is no value at all.
[[nodiscard]] app::Value plain_value(py::handle value);

/// An option beside the settings, as the text that the program would get: numbers in SI units.
/// @param unit  of numbers, "Pa"; empty = none.
[[nodiscard]] std::string option_text(const py::object& value, const char* unit = "");

/// The same of one that is wanted by name; None leaves the text as it is.
void take(const py::dict& wanted, const char* name, std::string& text, const char* unit = "");

/// (name, key, type, default, help) of every setting that an offer has a short name for, in the order of the
/// schema; those of phases are "PHASE.young".
[[nodiscard]] py::list described(const app::Offer& offer);

/// Whether it is str or os.PathLike.
[[nodiscard]] bool is_path(py::handle value);

/// The text of a path.   @throws TypeError.
[[nodiscard]] std::string path_text(const py::object& path);

}  // namespace binding
