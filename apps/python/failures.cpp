#include "apps/python/options.hpp"

#include "apps/settings/offer.hpp"

namespace binding {
namespace {

py::object exception_type(const char* name) { return py::module_::import("mesopix.errors").attr(name); }

py::object as_tuple(const app::Complaint& complaint) {
  return exception_type("Complaint")(app::text(complaint), app::text(complaint.place), complaint.field,
                                     complaint.value.empty() ? complaint.defect : complaint.value,
                                     complaint.allowed, complaint.cure);
}

py::object exception_of(const app::Rejected& refusal) {
  if (refusal.code == app::Exit::internal)
    return py::reinterpret_borrow<py::object>(PyExc_RuntimeError)(refusal.what());
  py::list complaints;
  for (const app::Complaint& complaint : refusal.complaints) complaints.append(as_tuple(complaint));
  return exception_type(refusal.code == app::Exit::io ? "FileError" : "Error")(*complaints);
}

void set_error(const py::object& exception) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

}  // namespace

void translate_refusals() {
  app::call_options_by(&app::with_underscores);                         // they are arguments here
  py::register_exception_translator([](std::exception_ptr exception) {  // NOLINT: the library's signature
    try {
      if (exception) std::rethrow_exception(exception);
    } catch (const app::Rejected& refusal) {
      set_error(exception_of(refusal));
    }
  });
}

namespace {

void warn(const char* category, const std::string& text) {
  constexpr int caller_of_the_package = 2;
  if (PyErr_WarnEx(exception_type(category).ptr(), text.c_str(), caller_of_the_package) != 0)
    throw py::error_already_set();
}

}  // namespace

void warn_of_length(const std::string& text) {
  if (!text.empty()) warn("LongRun", text);
}

void warn_of_doubts(const std::vector<std::string>& doubts) {
  for (const std::string& doubt : doubts) warn("Doubt", doubt);
}

void raise_with(const char* name, const std::string& text, const py::object& result) {
  set_error(exception_type(name)(text, result));
  throw py::error_already_set();
}

void raise_with(const app::Rejected& refusal, const py::object& result) {
  const py::object exception = exception_of(refusal);
  exception.attr("result") = result;
  set_error(exception);
  throw py::error_already_set();
}

}  // namespace binding
