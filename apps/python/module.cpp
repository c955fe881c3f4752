#include <pybind11/pybind11.h>

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/python/study.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/version.hpp"

namespace {

const app::Offer& offer_named(const std::string& function) {
  if (function == "generate") return app::offer_of_generate();
  if (function == "convert") return app::offer_of_convert();
  if (function == "twin") return app::offer_of_twin();
  if (function == "simulate" || function == "study") return app::offer_of_simulate();
  if (function == "calibrate") return app::offer_of_calibrate();
  if (function == "stiffness") return app::offer_of_stiffness();
  throw pybind11::value_error(function + " takes no settings");
}

}  // namespace

/// What the package mesopix is made of; who uses it sees the package alone.
PYBIND11_MODULE(_core, module) {
  pybind11::options options;
  options.disable_function_signatures();
  module.attr("version") = app::version();
  binding::translate_refusals();
  // Python's lock is that of h5py too.
  app::take_hdf5_turns_by([] { return std::make_shared<const pybind11::gil_scoped_acquire>(); });
  binding::bind_specimen(module);
  binding::bind_run(module);
  binding::bind_fit(module);
  binding::bind_study(module);
  binding::bind_twins(module);
  binding::bind_stiffness(module);
  module.def("described",
             [](const std::string& function) { return binding::described(offer_named(function)); });
}
