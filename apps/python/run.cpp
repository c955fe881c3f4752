#include "apps/python/study.hpp"

#include <pybind11/stl.h>
#include <optional>
#include <utility>

#include "apps/python/body.hpp"
#include "apps/python/options.hpp"
#include "apps/python/spectator.hpp"
#include "apps/python/views.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/frame_folder.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/run/run_length.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/solving.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/system/files.hpp"
#include "apps/text/figures.hpp"
#include "specimen/body/files.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

/// mesopix.Result: owner of all that its arrays show.
struct Run {
  app::Job job;
  mpm::Result result;
  output::ErrorEstimate estimate = {};
  bool is_given = false;  ///< the specimen is no file, and is written beside the result

  /// The resolved scene, as a folder would keep it.
  [[nodiscard]] std::string scene_toml(const fs::path& folder) const {
    app::Settings settings = job.settings;
    if (is_given) settings.specimen.file = (folder / specimen_name).string();
    return app::scene_text(settings, app::Extent::whole, folder);
  }

  /// What that folder is written from; it refers to the run.
  [[nodiscard]] RunRecord record(const fs::path& folder) const {
    std::string toml = scene_toml(folder), digest = specimen::sha256_of_text(toml);
    return {{job.specimen, job.scene, std::move(toml), std::move(digest), job.settings.title, job.notes},
            result,
            estimate};
  }
};

/// Arguments of mesopix.simulate beside what is broken and its settings.
struct RunWish {
  py::object output;  ///< folder, or None
  bool overwrite = false;
  bool estimate_error = false;
  py::object tolerance;  ///< or None
  py::object progress;   ///< callback, or None
};

/// One call of simulate: solves without the lock, and writes the folder that was asked for. Raises Diverged
/// and Interrupted with what was computed, and what the callback raises.
class Task {
 public:
  Task(Broken broken, const RunWish& wanted)
      : wanted_(wanted), broken_(std::move(broken)), spectator_(wanted.progress) {}

  std::shared_ptr<Run> carry_out() {
    const std::optional<double> tolerance = read_tolerance();
    run_->is_given = broken_.given.has_value();
    run_->job = app::make_job(broken_.resolved.settings, broken_.cells());
    if (std::string note = app::note_of_left_out(broken_.resolved.origins, broken_.resolved.settings);
        !note.empty())
      run_->job.notes.push_back(std::move(note));
    check(tolerance);
    tell_length();
    std::optional<app::FreshFolder> folder;
    std::optional<app::HeldFolder> held;
    if (!wanted_.output.is_none()) {
      folder.emplace(app::make_run_folder(path_text(wanted_.output), broken_.stem, wanted_.overwrite));
      held.emplace(folder->path());
    }
    if (tolerance) meet(*tolerance);
    std::optional<app::FrameFolder> frames;
    if (folder) frames.emplace(folder->path(), run_->job.scene);
    solve(frames ? &*frames : nullptr);
    if (folder) keep(folder->path(), *frames);
    conclude();
    return run_;
  }

 private:
  std::optional<double> read_tolerance() const {
    if (wanted_.tolerance.is_none()) return std::nullopt;
    return app::read_option("tolerance", option_text(wanted_.tolerance),
                            app::QuantityCodec{app::Dimension::ratio, app::inside(0, 1)});
  }

  /// A picture that takes long must be asked for, as of the program.
  void tell_length() const {
    const app::Job& job = run_->job;
    const app::RunLength length = [&] {
      const py::gil_scoped_release unlock;
      return app::length_of(job.scene);
    }();
    if (source_of(job.settings) == app::Source::picture &&
        !broken_.resolved.origins.contains("convert.pixels"))
      app::refuse_unasked_length(length, job.specimen.mask.labels.cols);
    warn_of_length(length.text);
  }

  void check(const std::optional<double>& tolerance) const {
    const mpm::Scene& scene = run_->job.scene;
    const char* estimate = tolerance ? "tolerance" : wanted_.estimate_error ? "estimate_error" : nullptr;
    if (tolerance && wanted_.estimate_error)
      throw app::Rejected(app::Exit::usage, "tolerance", "given with estimate_error", "",
                          "give one of the two");
    if (estimate != nullptr && !output::has_platens(scene))
      throw app::Rejected(app::Exit::usage, estimate, "there are no platens",
                          "needs a test in tension or compression");
    if (tolerance && scene.method == mpm::SolverMethod::quasi_static)
      throw app::Rejected(app::Exit::usage, "tolerance", option_text(wanted_.tolerance),
                          "is for explicit runs", "choose event_tolerance");
    if (scene.frames > 0 && wanted_.output.is_none())
      throw app::Rejected(app::Exit::usage, "output.frames", std::to_string(scene.frames),
                          "are written into a folder while the run goes on",
                          "give that folder as output, or 0 frames");
  }

  /// Runs that nothing is told of but Ctrl-C.
  app::Solve second_run() {
    return [this](const mpm::Scene& scene) {
      const py::gil_scoped_release unlock;
      return app::end_of_second_run(
          app::solve(scene, {.observer = [this](const mpm::Progress&) { return spectator_.go_on(); }}));
    };
  }

  void meet(double tolerance) {
    try {
      const app::Tolerated found = app::meet_tolerance(run_->job.scene, tolerance, second_run());
      app::require_met(found, tolerance, "tolerance");
      app::adopt(found, run_->job);
      run_->estimate = found.estimate;
    } catch (const app::NoEstimate& failed) {
      spectator_.conclude("interrupted", py::none());
      throw app::Rejected(app::Exit::data, "tolerance", "not met, " + failed.why, "", "nothing was written");
    }
  }

  app::Outcome solve_unlocked(app::FrameFolder* frames) {
    mpm::RunHooks hooks;
    hooks.observer = [this](const mpm::Progress& progress) {
      return spectator_.look([&] { return glance_at(progress); });
    };
    if (frames != nullptr)
      hooks.frames = [frames](const mpm::Frame& frame) {
        const py::gil_scoped_acquire lock;  // HDF5 is not safe everywhere
        (void)frames->add(frame);
      };
    const py::gil_scoped_release unlock;
    return app::solve(run_->job.scene, hooks);
  }

  void solve(app::FrameFolder* frames) {
    app::Outcome outcome = solve_unlocked(frames);
    spectator_.rethrow();
    for (const app::Remark& remark : remarks_on(outcome, run_->job.scene))
      run_->job.notes.push_back(remark.text);
    run_->estimate = wanted_.estimate_error ? app::estimate_of(outcome, run_->job, second_run())
                                            : app::of_a_peak(std::move(run_->estimate), outcome, run_->job);
    divergence_ = std::move(outcome.divergence);
    run_->result = std::move(outcome.result);
  }

  /// Write the folder; what the disk did not take is no reason to lose the result.
  void keep(const fs::path& folder, const app::FrameFolder& frames) {
    try {
      write_run(folder, run_->record(folder));
      if (const auto failure = frames.failure()) throw mpm::FileError(*failure);
    } catch (const mpm::FileError&) {
      lost_ = app::refusal_of(std::current_exception());
    }
  }

  /// Raise what has gone wrong, now that all is kept.
  void conclude() const {
    spectator_.conclude("interrupted; what was computed is in .result", py::cast(run_));
    if (lost_) raise_with(*lost_, py::cast(run_));
    if (!divergence_.empty()) raise_with("Diverged", divergence_, py::cast(run_));
  }

  const RunWish& wanted_;
  Broken broken_;
  Spectator spectator_;
  std::shared_ptr<Run> run_ = std::make_shared<Run>();
  std::string divergence_;
  std::optional<app::Rejected> lost_;  ///< files of the folder
};

std::shared_ptr<Run> simulate(const py::object& input, const py::dict& settings, const py::dict& options,
                              const py::object& output, bool overwrite, bool estimate_error,
                              const py::object& tolerance, const py::object& progress) {
  Broken broken = located({}, [&] {
    return broken_of(input, assignments(app::offer_of_simulate(), settings, options), "INPUT");
  });
  const RunWish wish{output, overwrite, estimate_error, tolerance, progress};
  return located(with_output("output", broken.resolved.origins),
                 [&] { return Task(std::move(broken), wish).carry_out(); });
}

const Run& run_of(const py::object& self) { return self.cast<const Run&>(); }

py::object run_figures(const Run& run) { return as_dict(summary(run.record(fs::current_path()))); }

py::array history(const py::object& self) { return view(run_of(self).result.history, self, history_type()); }

py::object curve(const py::object& self) {
  const py::array rows = history(self);
  return curve_of(rows["strain"], rows["stress"]);
}

/// The specimen stays with its run, which the pointer keeps.
Body specimen_of_run(const std::shared_ptr<Run>& run) {
  return {std::shared_ptr<const specimen::Specimen>(run, &run->job.specimen), {}};
}

std::shared_ptr<Run> read_result(const py::object& folder) {
  return located({}, [&] {
    app::ReadRun read = app::read_run(path_text(folder));
    auto run = std::make_shared<Run>();
    run->result = std::move(read.result);
    run->job = std::move(read);
    return run;
  });
}

void run_save(const Run& run, const py::object& folder, bool overwrite) {
  located(with_output("folder"), [&] {
    const fs::path made = app::make_run_folder(path_text(folder), "", overwrite);
    write_run(made, run.record(made));
  });
}

std::string run_representation(const Run& run) {
  const mpm::Result& result = run.result;
  return std::string("<mesopix.Result: ") +
         (mpm::peak_reached(result) ? "peak " : "no peak, largest stress ") +
         output::concise(1e-6 * result.peak_stress, 4) + " MPa at strain " +
         app::strain_text(result.peak_strain) + "; " + std::to_string(result.tension_failures) +
         " tension and " + std::to_string(result.shear_failures) + " shear failures; " +
         output::phrase_of(result.stop) + ">";
}

template <class T>
auto figure(T mpm::Result::*member) {
  return [member](const Run& run) { return run.result.*member; };
}

auto figure_of_peak(double mpm::Result::*member) {
  return [member](const Run& run) { return mpm::peak_of(run.result, member); };
}

template <class T>
auto map_of(mpm::PixelField<T> mpm::Result::*member) {
  return [member](const py::object& self) { return view(run_of(self).result.*member, self); };
}

void bind_arrays(py::class_<Run, std::shared_ptr<Run>>& type) {
  type.def_property_readonly(
          "history", &history,
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
  type.def_property_readonly(
          "peak_stress", figure_of_peak(&mpm::Result::peak_stress),
          "[Pa]; NaN where the run reached no peak: its largest stress had not fallen again by 5 %")
      .def_property_readonly("peak_strain", figure_of_peak(&mpm::Result::peak_strain),
                             "platen strain at the peak [-]; NaN where the run reached none")
      .def_property_readonly("largest_stress", figure(&mpm::Result::peak_stress), "[Pa], be it a peak or not")
      .def_property_readonly("strain_at_largest_stress", figure(&mpm::Result::peak_strain), "[-]")
      .def_property_readonly(
          "peak_reached", [](const Run& run) { return mpm::peak_reached(run.result); },
          "whether the largest stress is a peak; False where the stress had not fallen again")
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
      .def_property_readonly("summary", &run_figures, "figures, a dict as summary.json of a run folder")
      .def_property_readonly(
          "scene", [](const Run& run) { return run.scene_toml(fs::current_path()); },
          "the resolved scene, every default written out, TOML")
      .def_property_readonly("specimen", &specimen_of_run,
                             "Specimen that was broken, in whole cells of the grid");
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>> type(
      module, "Result", "What a run leaves behind. Its arrays are read-only views, and keep it alive.");
  bind_arrays(type);
  bind_figures(type);
  type.def("save", &run_save, py::arg("folder"), py::arg("overwrite") = false,
           "save(folder, overwrite=False)\n\nWrite the run folder that mesopix simulate writes: tables, "
           "pictures, "
           "report.html, the scene and the specimen.\nRaises Error for a folder that is not empty, FileError "
           "with "
           "the files that are missing when the disk fails.")
      .def("__repr__", &run_representation);
  module.def("simulate", &simulate);
  module.def("read_result", &read_result);
}

}  // namespace binding
