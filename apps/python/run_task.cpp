#include "apps/python/run_task.hpp"

#include <optional>
#include <utility>

#include "apps/run/frame_folder.hpp"
#include "apps/system/held_folder.hpp"
#include "apps/scene/input.hpp"
#include "apps/report/load_words.hpp"
#include "apps/python/body.hpp"
#include "apps/python/failures.hpp"
#include "apps/python/options.hpp"
#include "apps/python/progress.hpp"
#include "apps/python/spectator.hpp"
#include "apps/settings/read_option.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/solving.hpp"
#include "specimen/body/digest.hpp"

namespace binding {
namespace {

namespace fs = std::filesystem;

/// One call of simulate.
class Task {
 public:
  Task(Broken broken, const Wanted& wanted)
      : wanted_(wanted), broken_(std::move(broken)), spectator_(wanted.progress) {}

  std::shared_ptr<Run> carry_out() {
    const std::optional<double> tolerance = read_tolerance();
    run_->is_given = broken_.given.has_value();
    run_->job = app::make_job(broken_.resolved.settings, broken_.cells());
    check(tolerance);
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
    return app::read_option("--tolerance", option_text(wanted_.tolerance),
                            app::Quantity{app::Dimension::ratio, app::inside(0, 1), {}});
  }

  void check(const std::optional<double>& tolerance) const {
    const mpm::Scene& scene = run_->job.scene;
    const char* estimate = tolerance ? "tolerance" : wanted_.estimate_error ? "estimate_error" : nullptr;
    if (tolerance && wanted_.estimate_error)
      throw app::Rejected(app::Exit::usage, app::complaint("tolerance", "given with estimate_error", "",
                                                           "give one of the two"));
    if (estimate != nullptr && !output::has_platens(scene))
      throw app::Rejected(app::Exit::usage, app::complaint(estimate, "there are no platens",
                                                           "needs a test in tension or compression"));
    if (scene.frames > 0 && wanted_.output.is_none())
      throw app::Rejected(app::Exit::usage, app::complaint("output.frames", std::to_string(scene.frames),
                                                           "are written into a folder while the run goes on",
                                                           "give that folder as output, or 0 frames"));
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
      app::adopt(found, tolerance, run_->job);
      run_->estimate = found.estimate;
    } catch (const app::NoEstimate& failed) {
      spectator_.rethrow();
      if (spectator_.interrupted()) raise_with("Interrupted", "interrupted", py::none());
      throw app::Rejected(app::Exit::data,
                          app::complaint("tolerance", "not met, " + failed.why, "", "nothing was written"));
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
    if (wanted_.estimate_error) run_->estimate = app::estimate_of(outcome, run_->job, second_run());
    divergence_ = std::move(outcome.divergence);
    run_->result = std::move(outcome.result);
  }

  /// Write the folder; what the disk did not take is no reason to lose the result.
  void keep(const fs::path& folder, const app::FrameFolder& frames) {
    try {
      write(folder, *run_);
      if (const auto failure = frames.failure()) throw mpm::FileError(*failure);
    } catch (const mpm::FileError&) {
      lost_ = app::refusal_of(std::current_exception(), {});
    }
  }

  /// Raise what has gone wrong, now that all is kept.
  void conclude() const {
    spectator_.rethrow();
    if (spectator_.interrupted())
      raise_with("Interrupted", "interrupted; what was computed is in .result", py::cast(run_));
    if (lost_) raise_with(*lost_, py::cast(run_));
    if (!divergence_.empty()) raise_with("Diverged", divergence_, py::cast(run_));
  }

  const Wanted& wanted_;
  Broken broken_;
  Spectator spectator_;
  std::shared_ptr<Run> run_ = std::make_shared<Run>();
  std::string divergence_;
  std::optional<app::Rejected> lost_;  ///< files of the folder
};

app::Origins with_output(app::Origins origins) {
  origins["-o"] = {"-o", {}, {}, "output", ""};
  return origins;
}

}  // namespace

std::shared_ptr<Run> simulate(const py::object& input, const Wanted& wanted) {
  Broken broken = located({}, [&] {
    return broken_of(input, assignments(app::offer_of_simulate(), wanted.settings, wanted.options),
                     [](const std::string& given, std::vector<app::Assignment> options) {
                       return app::resolve_input("INPUT", given, std::move(options));
                     });
  });
  const app::Origins origins = with_output(broken.resolved.origins);
  return located(origins, [&] { return Task(std::move(broken), wanted).carry_out(); });
}

void write(const fs::path& folder, const Run& run) {
  const std::string toml = run.scene_toml(folder);
  write_run(folder, {run.job.specimen, run.job.scene, run.result, toml, specimen::sha256_of_text(toml),
                     run.job.settings.title, run.job.notes, run.estimate});
}

}  // namespace binding
