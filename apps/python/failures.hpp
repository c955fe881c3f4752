/// Exceptions of ours as exceptions of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <string>

#include "apps/settings/assignment.hpp"
#include "apps/settings/refusal.hpp"

namespace binding {

namespace py = pybind11;

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
    throw app::refusal_of(std::current_exception(), origins);
  }
}

/// app::Rejected becomes mesopix.FileError (Exit::io), RuntimeError (Exit::internal), or else mesopix.Error.
void translate_refusals();

/// Raise mesopix.NAME(text, result): Diverged or Interrupted.
[[noreturn]] void raise_with(const char* name, const std::string& text, const py::object& result);

/// Raise what a refusal becomes, with what was computed as .result.
[[noreturn]] void raise_with(const app::Rejected& refusal, const py::object& result);

}  // namespace binding
