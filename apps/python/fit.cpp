#include "apps/python/study.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/calibrate/calibration_folder.hpp"
#include "apps/calibrate/calibration_report.hpp"
#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/python/spectator.hpp"
#include "apps/python/views.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/text/figures.hpp"
#include "specimen/file/specimen_file.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

/// mesopix.Calibration: owner of all that its arrays show.
struct Fit {
  app::Job job;
  std::optional<app::CalibrationTask> task;  ///< of the job
  app::Calibration found;
  bool is_given = false;  ///< the specimen is no file, and is written beside the scene
};

using FitPointer = std::shared_ptr<Fit>;

app::Curve measured_curve(const py::object& target) {
  if (target.is_none() || is_path(target)) return {};
  const auto [strain, stress] = target.cast<std::pair<std::vector<double>, std::vector<double>>>();
  std::string table = "strain,stress_Pa\n";
  for (std::size_t i = 0; i < std::min(strain.size(), stress.size()); ++i)
    table += fmt::format("{},{}\n", strain[i], stress[i]);
  if (strain.size() != stress.size())
    throw app::Rejected(app::Exit::usage, "target",
                        fmt::format("{} strains and {} stresses", strain.size(), stress.size()),
                        "must be as many");
  return app::parse_target_curve(table, "target");
}

app::CalibrationWish fit_wish_of(const py::dict& wanted) {
  app::CalibrationWish wish;
  take(wanted, "peak_stress", wish.peak_stress, "Pa");
  take(wanted, "peak_strain", wish.peak_strain);
  take(wanted, "seeds", wish.seeds);
  take(wanted, "tolerance", wish.tolerance);
  take(wanted, "max_evaluations", wish.evaluations);
  const py::object free = wanted["free"], target = wanted["target"];
  if (!free.is_none())
    wish.free = (py::isinstance<py::str>(free) ? free : py::str(",").attr("join")(free)).cast<std::string>();
  if (is_path(target)) wish.curve = path_text(target);
  return wish;
}

app::Calibration search(const app::CalibrationTask& task, Spectator& spectator) {
  return work_apart(spectator, [&](Overseer& overseer) {
    return app::calibrate(
        task, [&] { return !overseer.goes_on(); },
        [&](const app::Calibration& so_far) { overseer.look([&] { return glance_at(so_far); }); });
  });
}

FitPointer calibrate(const py::object& input, const py::dict& settings, const py::dict& options,
                     const py::dict& wanted, const py::object& progress) {
  const app::CalibrationWish wish = located({}, [&] { return fit_wish_of(wanted); });
  app::Target target = located({}, [&] { return read_target(wish, measured_curve(wanted["target"])); });
  Broken broken = located({}, [&] {
    return broken_of(input, assignments(app::offer_of_calibrate(), settings, options), "SCENE");
  });
  return located(broken.resolved.origins, [&] {
    app::check_loading(broken.resolved.settings.scene);
    auto fit = std::make_shared<Fit>();
    fit->is_given = broken.given.has_value();
    fit->job = app::make_job(broken.resolved.settings, broken.cells());
    if (std::string doubt = doubt_of(target); !doubt.empty()) fit->job.notes.push_back(std::move(doubt));
    fit->task.emplace(app::make_task(fit->job, std::move(target), wish));
    warn_of_length([&] {
      const py::gil_scoped_release unlock;
      return announcement(*fit->task);
    }());
    Spectator spectator(progress);
    fit->found = search(*fit->task, spectator);
    const bool nothing = fit->found.history.empty();
    spectator.conclude(
        nothing ? "interrupted before anything was found" : "interrupted; the best so far is in .result",
        nothing ? py::none() : py::cast(fit));
    return fit;
  });
}

py::dict values(const Fit& fit) {
  py::dict settings;
  const std::vector<double>& factors = fit.found.best_evaluation().factors;
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (const app::ScaledSetting& setting : fit.task->parameters[i].settings)
      settings[py::str(setting.field.key)] = setting.text(factors[i]);
  return settings;
}

app::Calibration in_folder(const Fit& fit, const fs::path& folder) {
  app::Calibration found = fit.found;
  if (fit.is_given) found.settings.specimen.file = (folder / specimen_name).string();
  return found;
}

std::string scene(const Fit& fit) {
  const fs::path here = fs::current_path();
  return app::scene_text(in_folder(fit, here).settings, app::Extent::whole, here);
}

void fit_save(const Fit& fit, const py::object& wanted, bool overwrite) {
  located(with_output("folder"), [&] {
    const fs::path folder = app::make_run_folder(path_text(wanted), "", overwrite);
    const Attempts written = write_calibration(folder, *fit.task, in_folder(fit, folder));
    if (fit.is_given) specimen::write_specimen((folder / specimen_name).string(), fit.job.specimen);
    written.conclude();
  });
}

py::list fit_curves(const py::object& self) {
  py::list all;
  for (const app::SeedRun& run : self.cast<const Fit&>().found.runs)
    all.append(curve_of(view(run.curve.strain, self), view(run.curve.stress, self)));
  return all;
}

std::string unmet(const Fit& fit) { return why_not_met(*fit.task, fit.found); }

std::string fit_representation(const Fit& fit) {
  std::string text = "<mesopix.Calibration to " + target_text(fit.task->target) + ": misfit " +
                     output::concise(100 * fit.found.misfit, 3) + " %";
  for (const auto& [key, value] : values(fit))
    text += "; " + key.cast<std::string>() + " = " + value.cast<std::string>();
  return text + ">";
}

}  // namespace

void bind_fit(py::module_& module) {
  py::class_<Fit, FitPointer>(module, "Calibration",
                              "What a fit came to. Its arrays are read-only views, and keep it alive.")
      .def_property_readonly("settings", &values,
                             "what was fitted, {key: value}, as simulate takes it: simulate(specimen, "
                             "calibration.settings)")
      .def_property_readonly(
          "met", [](const Fit& fit) { return unmet(fit).empty(); }, "whether the target was met")
      .def_property_readonly("why_not_met", &unmet, "in a sentence; empty when it was met")
      .def_property_readonly(
          "misfit", [](const Fit& fit) { return fit.found.misfit; },
          "of the fitted scene: relative error of a peak, or that of stresses over the peak stress for a "
          "curve [-]")
      .def_property_readonly(
          "curves", &fit_curves,
          "Curve(strain [-], stress [Pa]) of the fitted scene, one a seed; read-only views")
      .def_property_readonly(
          "notes", [](const Fit& fit) { return py::tuple(py::cast(fit.job.notes)); },
          "what was guessed on the way, one sentence each")
      .def_property_readonly(
          "summary", [](const Fit& fit) { return as_dict(calibration_json(*fit.task, fit.found)); },
          "figures, a dict as calibration.json")
      .def_property_readonly("scene", &scene, "the scene with what was fitted, TOML")
      .def("save", &fit_save, py::arg("folder"), py::arg("overwrite") = false,
           "save(folder, overwrite=False)\n\nWrite scene.toml with what was fitted, calibration.json and "
           "report.html.\nRaises Error for a folder that is not empty, FileError when the disk fails.")
      .def("__repr__", &fit_representation);
  module.def("calibrate", &calibrate);
}

}  // namespace binding
