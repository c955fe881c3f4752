#include "apps/python/run.hpp"

#include <pybind11/stl.h>

#include "apps/report/run_words.hpp"
#include "apps/text/text.hpp"
#include "apps/python/body.hpp"
#include "apps/python/failures.hpp"
#include "apps/python/json.hpp"
#include "apps/python/options.hpp"
#include "apps/python/run_task.hpp"
#include "apps/python/views.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/run_reader.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/text/strain_text.hpp"
#include "specimen/body/digest.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

const Run& run_of(const py::object& self) { return self.cast<const Run&>(); }

py::object figures(const Run& run) {
  const std::string toml = run.scene_toml(fs::current_path());
  return as_dict(summary({run.job.specimen, run.job.scene, run.result, toml, specimen::sha256_of_text(toml),
                          run.job.settings.title, run.job.notes, run.estimate}));
}

py::object curve(const py::object& self) {
  const py::array history = view(run_of(self).result.history, self);
  return py::module_::import("mesopix.results").attr("Curve")(history["strain"], history["stress"]);
}

/// The specimen stays with its run, which the pointer keeps.
Body body_of(const std::shared_ptr<Run>& run) {
  return {std::shared_ptr<const specimen::Specimen>(run, &run->job.specimen), {}};
}

std::shared_ptr<Run> read_result(const py::object& folder) {
  return located({}, [&] {
    app::ReadRun read = app::read_run(path_text(folder));
    auto run = std::make_shared<Run>();
    run->job = {std::move(read.settings), std::move(read.specimen), std::move(read.scene), {}};
    run->result = std::move(read.result);
    return run;
  });
}

void save(const Run& run, const py::object& folder, bool overwrite) {
  const app::Origins origins{{"-o", {"-o", {}, {}, "folder", ""}}};
  located(origins, [&] { write(app::make_run_folder(path_text(folder), "", overwrite), run); });
}

std::string representation(const Run& run) {
  const mpm::Result& result = run.result;
  return "<mesopix.Result: peak " + output::trimmed(1e-6 * result.peak_stress, 4) + " MPa at strain " +
         app::strain_text(result.peak_strain) + "; " + std::to_string(result.tension_failures) +
         " tension and " + std::to_string(result.shear_failures) + " shear failures; " +
         output::phrase_of(result.stop) + ">";
}

template <class T>
auto figure(T mpm::Result::*member) {
  return [member](const Run& run) { return run.result.*member; };
}

template <class T>
auto map_of(mpm::Lattice<T> mpm::Result::*member) {
  return [member](const py::object& self) { return view(run_of(self).result.*member, self); };
}

void bind_arrays(py::class_<Run, std::shared_ptr<Run>>& type) {
  type.def_property_readonly(
          "history", [](const py::object& self) { return view(run_of(self).result.history, self); },
          "structured array, a row a moment and a column a quantity, as curve.csv and in SI units: "
          "history[\"stress\"] [Pa]")
      .def_property_readonly("curve", &curve, "Curve(strain [-], stress [Pa]): two columns of the history")
      .def_property_readonly(
          "failure_strain", map_of(&mpm::Result::failure_strain),
          "platen strain at which the point of a pixel failed [-], float32 of shape (rows, "
          "columns), row 0 on top; NaN = it did not")
      .def_property_readonly(
          "failure_mode", map_of(&mpm::Result::failure_mode),
          "how it failed, uint8 of the same shape: 0 = it did not, 1 = in tension, 2 = in shear")
      .def_property_readonly(
          "crush_strain", map_of(&mpm::Result::crush_strain),
          "platen strain at which a cracked point was crushed, float32; None without crack "
          "closure")
      .def_property_readonly(
          "end_x", map_of(&mpm::Result::end_x),
          "where the point of a pixel is at the end [m], float32; None without moving points")
      .def_property_readonly("end_y", map_of(&mpm::Result::end_y), "the same upwards [m]");
}

void bind_figures(py::class_<Run, std::shared_ptr<Run>>& type) {
  type.def_property_readonly("peak_stress", figure(&mpm::Result::peak_stress), "[Pa]")
      .def_property_readonly("peak_strain", figure(&mpm::Result::peak_strain),
                             "platen strain at the peak [-]")
      .def_property_readonly("tension_failures", figure(&mpm::Result::tension_failures), "points")
      .def_property_readonly("shear_failures", figure(&mpm::Result::shear_failures), "points")
      .def_property_readonly("steps", figure(&mpm::Result::steps), "time steps")
      .def_property_readonly("dt", figure(&mpm::Result::dt), "time step [s]")
      .def_property_readonly("wall_time", figure(&mpm::Result::wall_time), "of the time loop [s]")
      .def_property_readonly(
          "stop", [](const Run& run) { return output::word_of(run.result.stop); }, "why the run ended")
      .def_property_readonly(
          "notes", [](const Run& run) { return py::tuple(py::cast(run.job.notes)); },
          "what was guessed or went otherwise, one sentence each")
      .def_property_readonly("summary", &figures, "figures, a dict as summary.json of a run folder")
      .def_property_readonly(
          "scene", [](const Run& run) { return run.scene_toml(fs::current_path()); },
          "the resolved scene, every default written out, TOML")
      .def_property_readonly("specimen", &body_of, "Specimen that was broken, in whole cells of the grid");
}

std::shared_ptr<Run> simulate_call(const py::object& input, const py::dict& settings, const py::dict& options,
                                   const py::object& output, bool overwrite, bool estimate_error,
                                   const py::object& tolerance, const py::object& progress) {
  return simulate(input, {settings, options, output, overwrite, estimate_error, tolerance, progress});
}

}  // namespace

std::string Run::scene_toml(const fs::path& folder) const {
  if (!is_given) return app::scene_text(job.settings, app::Extent::whole, folder);
  app::Settings settings = job.settings;
  settings.specimen.file = (folder / specimen_name).string();
  return app::scene_text(settings, app::Extent::whole, folder);
}

void bind_run(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>> type(
      module, "Result", "What a run leaves behind. Its arrays are read-only views, and keep it alive.");
  bind_arrays(type);
  bind_figures(type);
  type.def("save", &save, py::arg("folder"), py::arg("overwrite") = false,
           "save(folder, overwrite=False)\n\nWrite the run folder that mesopix simulate writes: tables, "
           "pictures, "
           "report.html, the scene and the specimen.\nRaises Error for a folder that is not empty, FileError "
           "with "
           "the files that are missing when the disk fails.")
      .def("__repr__", &representation);
  module.def("simulate", &simulate_call);
  module.def("read_result", &read_result);
}

}  // namespace binding
