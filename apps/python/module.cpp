#include <pybind11/pybind11.h>

#include "apps/python/body.hpp"
#include "apps/python/failures.hpp"
#include "apps/python/fit.hpp"
#include "apps/python/options.hpp"
#include "apps/python/run.hpp"
#include "apps/version.hpp"

namespace {

const app::Offer& offer_named(const std::string& function) {
  if (function == "generate") return app::offer_of_generate();
  if (function == "convert") return app::offer_of_convert();
  if (function == "simulate") return app::offer_of_simulate();
  if (function == "calibrate") return app::offer_of_calibrate();
  throw pybind11::value_error(function + " takes no settings");
}

}  // namespace

/// What the package mesopix is made of; who uses it sees the package alone.
PYBIND11_MODULE(_core, module) {
  pybind11::options options;
  options.disable_function_signatures();
  module.attr("version") = app::version();
  binding::translate_refusals();
  binding::bind_specimen(module);
  binding::bind_run(module);
  binding::bind_fit(module);
  module.def("described",
             [](const std::string& function) { return binding::described(offer_named(function)); });
}
