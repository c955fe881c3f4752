#include "apps/simulate_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/attempts.hpp"
#include "apps/energy_note.hpp"
#include "apps/error_estimation.hpp"
#include "apps/explanation.hpp"
#include "apps/frame_folder.hpp"
#include "apps/interrupt.hpp"
#include "apps/live/live_view.hpp"
#include "apps/output/load_words.hpp"
#include "apps/output/run_words.hpp"
#include "apps/output/text.hpp"
#include "apps/progress_line.hpp"
#include "apps/read_option.hpp"
#include "apps/run_folder.hpp"
#include "apps/run_location.hpp"
#include "apps/scene_builder.hpp"
#include "apps/scene_file.hpp"
#include "apps/scene_text.hpp"
#include "apps/specimen_source.hpp"
#include "apps/strain_text.hpp"
#include "libmpm/simulate.hpp"
#include "specimen/digest.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer =
    "Example: tension until the stress has dropped to 20 % of its peak\n"
    "  mesopix simulate specimen.h5 --velocity \"0.02 m/s\" --stop-drop 0.2 --mortar.tensile-scale \"12 "
    "MPa\" -o run\n"
    "The settings of the specimen are options too, by their keys: --generate.fraction 0.4, --convert.width "
    "\"150 mm\";\nsee mesopix generate --help and mesopix convert --help. --print-scene shows all of them as "
    "a scene.";

Resolved resolve_input(const std::string& input, std::vector<Assignment> given) {
  const InputKind kind = kind_of_input(input);
  if (kind == InputKind::folder)
    throw Rejected(Exit::usage,
                   complaint("INPUT", input, "is a folder; must be a specimen, a scene or a picture"));
  if (kind == InputKind::scene) return resolve(read_scene_file(input), given);
  const char* key = kind == InputKind::hdf5 ? "specimen.file" : "specimen.picture";
  given.insert(given.begin(), given_as_option(key, Kind::path, "INPUT", input));
  return resolve({}, given);
}

/// What a run ended with, kept whether it came to its end or not.
struct Outcome {
  mpm::Result result;
  std::string divergence;  ///< what went wrong; empty when nothing did
};

Outcome solve(const mpm::Scene& scene, Console& console, const InterruptGuard& guard,
              const mpm::FrameSink& frames = {}, LiveView* view = nullptr) {
  ProgressLine line(console.err, scene, console.err_is_terminal && !console.quiet);
  try {
    return {mpm::simulate(
                scene,
                [&](const mpm::Progress& progress) {
                  line.show(progress);
                  return (view == nullptr || view->look(progress)) && !guard.interrupted();
                },
                frames),
            {}};
  } catch (const mpm::Diverged& diverged) {
    return {diverged.result, diverged.what()};
  }
}

/// A second run that was interrupted, or went wrong.
struct NoEstimate {
  bool interrupted = false;
  std::string why;
};

/// Nothing is kept of second runs but what they end with.
Solve second_run(Console& console, const InterruptGuard& guard) {
  return [&](const mpm::Scene& scene) {
    Outcome outcome = solve(scene, console, guard);
    if (!outcome.divergence.empty()) throw NoEstimate{false, outcome.divergence};
    if (outcome.result.stop == mpm::StopReason::interrupted) throw NoEstimate{true, "it was interrupted"};
    return std::move(outcome.result);
  };
}

std::string percent_text(double error) { return output::rounded(100 * error, 2) + " %"; }

std::string estimate_text(const output::ErrorEstimate& estimate) {
  std::string parts;
  for (const output::ErrorSource& source : estimate.sources)
    parts += (parts.empty() ? "" : ", ") + source.name + " " + percent_text(source.stress_error);
  return fmt::format(
      "the peak stress may be wrong by {} and its strain by {} ({}), estimated in {:.2f} s more",
      percent_text(estimate.stress_error()), percent_text(estimate.strain_error()), parts,
      estimate.wall_time());
}

std::string result_text(const mpm::Result& result, const mpm::Scene& scene) {
  const bool platens = output::has_platens(scene);
  return fmt::format("peak {}{:.4g} MPa at {} {}, {} tension and {} shear failures, {} steps in {:.2f} s",
                     platens ? "" : output::name_of_stress(scene) + " ", 1e-6 * result.peak_stress,
                     platens ? "strain" : output::name_of_strain(scene), strain_text(result.peak_strain),
                     result.tension_failures, result.shear_failures, result.steps, result.wall_time);
}

/// What is solved, and what was noted on the way there.
struct Job {
  Settings settings;
  specimen::Specimen specimen;
  mpm::Scene scene;
  std::vector<std::string> notes;
};

Job prepare_job(Settings settings, Console& console) {
  Prepared prepared = prepare_specimen(settings);
  for (std::string& note : crop_to_cells(prepared.specimen, settings.scene.points_per_cell))
    prepared.notes.push_back(std::move(note));
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  mpm::Scene scene = build_scene(prepared.specimen, settings);
  mpm::validate(scene);
  return {std::move(settings), std::move(prepared.specimen), std::move(scene), std::move(prepared.notes)};
}

/// Gives the scene the rate, step and precision that the tolerance asks for.   @return their error.
output::ErrorEstimate meet(double tolerance, Job& job, Console& console, const InterruptGuard& guard) {
  const Tolerated found = meet_tolerance(job.scene, tolerance, second_run(console, guard));
  for (mpm::Scene* scene : {&job.scene, &job.settings.scene}) {
    scene->loading.velocity = found.scene.loading.velocity;
    scene->cfl = found.scene.cfl;
    scene->precision = found.scene.precision;
  }
  console.say(
      fmt::format("a tolerance of {} is {} at {} m/s, CFL {} and {} precision, found in {:.2f} s",
                  output::trimmed(100 * tolerance) + " %", found.met ? "met" : "not met",
                  output::trimmed(found.scene.loading.velocity, 4), output::trimmed(found.scene.cfl, 4),
                  found.scene.precision == mpm::Precision::single ? "single" : "double", found.wall_time));
  if (!found.met)
    job.notes.push_back(
        "the tolerance of " + output::trimmed(100 * tolerance) +
        " % was not met: where points fail, another order of failures changes the peak as much");
  return found.estimate;
}

/// Of a run that came to its end; without sources where a second run did not, which is noted.
output::ErrorEstimate estimate_of(const Outcome& outcome, Job& job, Console& console,
                                  const InterruptGuard& guard) {
  if (!outcome.divergence.empty() || outcome.result.stop == mpm::StopReason::interrupted) return {};
  try {
    return estimate_error(job.scene, outcome.result, second_run(console, guard));
  } catch (const NoEstimate& failed) {
    job.notes.push_back("there is no estimate of the error: " + failed.why);
    console.say("note: " + job.notes.back());
    return {};
  }
}

/// What the run itself leaves to be noted.
void note_outcome(const Outcome& outcome, Job& job, Console& console) {
  if (!outcome.divergence.empty()) {
    job.notes.push_back(outcome.divergence);
    return;
  }
  if (outcome.result.nothing_carries) {
    job.notes.push_back("nothing carries load any more: every point has failed; the run ended at strain " +
                        strain_text(outcome.result.history.back().strain));
    console.say("note: " + job.notes.back());
  }
  if (const std::string note = energy_note(outcome.result, job.scene); !note.empty()) {
    job.notes.push_back(note);
    const bool expected = job.scene.kinematics != mpm::Kinematics::small_strain;
    console.say((expected ? "note: " : "warning: ") + note);
  }
}

/// A disk that is full ends no run: it may have space again for the next frame, and for what comes of the
/// run.
mpm::FrameSink frame_sink(FrameFolder& frames, Console& console) {
  return [&frames, &console, warned = false](const mpm::Frame& frame) mutable {
    if (frames.add(frame) || warned) return;
    warned = true;
    console.say(std::string(console.err_is_terminal ? "\n" : "") + "warning: " + frames.failure()->what() +
                "; the run goes on");
  };
}

/// What the disk did not take.
using Lost = std::vector<mpm::FileError>;

Lost write_what_fits(const fs::path& folder, const RunRecord& record, const FrameFolder& frames) {
  Lost lost;
  if (const auto failure = frames.failure()) lost.push_back(*failure);
  try {
    write_run(folder, record);
  } catch (const NotWritten& missing) {
    lost.insert(lost.end(), missing.files.begin(), missing.files.end());
  }
  return lost;
}

/// How a run ended, for those who watched it.
std::string last_words(const Outcome& outcome, const fs::path& folder, const Lost& lost) {
  const std::string how =
      outcome.divergence.empty() ? output::phrase_of(outcome.result.stop) : outcome.divergence;
  return "The run has ended: " + how + ". " +
         (lost.empty() ? "Its report is " + (folder / "report.html").string() : lost.front().what());
}

/// @throws Rejected when the physics went wrong, or the disk.
Exit exit_of(const Outcome& outcome, const fs::path& folder, const Lost& lost, Console& console) {
  std::vector<Complaint> complaints;
  if (!outcome.divergence.empty())
    complaints.push_back(
        complaint("simulate", outcome.divergence, "what was computed is in " + folder.string()));
  for (const mpm::FileError& file : lost)
    complaints.push_back(complaint(file.field, file.value, file.allowed, file.cure));
  if (!complaints.empty()) throw Rejected(lost.empty() ? Exit::data : Exit::io, complaints);
  if (outcome.result.stop != mpm::StopReason::interrupted) return Exit::ok;
  console.say("interrupted; what was computed is kept");
  return Exit::interrupted;
}

}  // namespace

SimulateCommand::SimulateCommand(CLI::App& program)
    : Command(program, "simulate", "Break a specimen, and write what happened into a folder", footer),
      settings_(options(), {{"phases", "loading", "damage", "solver", "motion", "handover", "output"},
                            {"specimen", "generate", "convert", "itz"},
                            {}}) {
  options().add_option("INPUT", input_, "specimen.h5, scene.toml or picture")->type_name("");
  options().add_option("-o,--output", output_, "folder [runs/INPUT, runs/INPUT-2, ...]")->type_name("DIR");
  options().add_flag("--overwrite", overwrite_, "write into a folder that is not empty");
  options().add_flag("--print-scene", print_scene_, "print the resolved scene, and do no more");
  options().add_flag("--explain", explain_,
                     "print what the run computes, what it leaves out and what that saves, and do no more");
  options().add_flag(
      "--estimate-error", estimate_error_,
      "say how wrong the peak may be, from runs at another rate, step, precision and pixel size");
  options()
      .add_option(
          "--tolerance", tolerance_,
          "choose the rate, the step and the precision that keep the error of the peak stress below this, "
          "e.g. \"1 %\"")
      ->type_name("RATIO");
  options().add_flag("--serve", serve_,
                     "show the report in a browser on this machine while the run goes on, with a button that "
                     "stops it; the address is printed");
  options().add_option("--port", port_, "of --serve on 127.0.0.1 [any that is free]")->type_name("NUMBER");
  options().add_flag("--json", json_, "summary as JSON on standard output");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

std::vector<std::string> SimulateCommand::prepare(const std::vector<std::string>& arguments) {
  return settings_.take_phase_options(arguments);
}

void SimulateCommand::check_options() const {
  if (input_.empty())
    throw Rejected(Exit::usage, complaint("INPUT", "missing", "", "mesopix simulate INPUT"));
  const char* error = !tolerance_.empty() ? "--tolerance"
                      : estimate_error_   ? "--estimate-error"
                      : serve_            ? "--serve"
                                          : nullptr;
  const char* other = explain_                                 ? "--explain"
                      : print_scene_                           ? "--print-scene"
                      : !tolerance_.empty() && estimate_error_ ? "--estimate-error"
                                                               : nullptr;
  if (error != nullptr && other != nullptr)
    throw Rejected(Exit::usage,
                   complaint(error, std::string("given with ") + other, "", "give one of the two"));
}

/// 0 = any that is free.
int SimulateCommand::port() const {
  if (port_.empty()) return 0;
  if (!serve_)
    throw Rejected(Exit::usage,
                   complaint("--port", port_, "is for --serve, which is not given", "add --serve"));
  return read_option("--port", port_, Integer<int>{{between(1, 65535), {}}});
}

double SimulateCommand::tolerance() const {
  return read_option("--tolerance", tolerance_, Quantity{Dimension::ratio, inside(0, 1), {}});
}

Exit SimulateCommand::run(Console& console) {
  console.quiet = quiet_;
  check_options();
  const int port = this->port();
  const std::optional<double> wanted = tolerance_.empty() ? std::nullopt : std::optional(tolerance());
  Resolved resolved = resolve_input(input_, settings_.assignments());
  console.origins = resolved.origins;
  Settings& settings = resolved.settings;
  settle_source(settings);
  if (settings.title.empty()) settings.title = fs::path(input_).stem().string();
  if (print_scene_) {
    console.out << scene_text(settings, Extent::whole, fs::current_path());
    return Exit::ok;
  }
  Job job = prepare_job(std::move(settings), console);
  if (explain_) {
    const mpm::Explanation explanation = mpm::explain(job.scene);
    console.out << (json_ ? explanation_json(explanation).dump(2) + "\n" : explanation_text(explanation));
    return Exit::ok;
  }
  if ((estimate_error_ || wanted) && !output::has_platens(job.scene))
    throw Rejected(Exit::usage, complaint(wanted ? "--tolerance" : "--estimate-error", "there are no platens",
                                          "needs a test in tension or compression"));
  const FreshFolder folder(make_run_folder(output_, fs::path(input_).stem(), overwrite_));
  const InterruptGuard guard;
  output::ErrorEstimate estimate;
  try {
    if (wanted) estimate = meet(*wanted, job, console, guard);
  } catch (const NoEstimate& failed) {
    throw Rejected(failed.interrupted ? Exit::interrupted : Exit::data,
                   complaint("--tolerance", "not met, " + failed.why, "", "nothing was written"));
  }
  const std::string toml = scene_text(job.settings, Extent::whole, folder.path());
  const std::string hash = specimen::sha256_of_text(toml);
  std::optional<LiveView> view;
  if (serve_) {
    view.emplace(LiveRun{job.specimen, job.scene, toml, hash, job.settings.title, job.notes}, port);
    console.err << "watch the run at " << view->address() << std::endl;
  }
  FrameFolder frames(folder.path(), job.scene);
  const Outcome outcome =
      solve(job.scene, console, guard, frame_sink(frames, console), view ? &*view : nullptr);
  if (estimate_error_) estimate = estimate_of(outcome, job, console, guard);
  note_outcome(outcome, job, console);
  const RunRecord record{job.specimen, job.scene,          outcome.result, toml,
                         hash,         job.settings.title, job.notes,      estimate};
  const Lost lost = write_what_fits(folder.path(), record, frames);
  if (view) view->finish(outcome.result, last_words(outcome, folder.path(), lost));
  if (json_)
    console.out << summary(record).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  else
    console.say(result_text(outcome.result, job.scene));
  if (!estimate.sources.empty()) console.say(estimate_text(estimate));
  if (frames.count() > 0)
    console.say(fmt::format("{} frames for ParaView: {}", frames.count(), frames.series().string()));
  if (lost.empty()) console.say("wrote " + folder.path().string());
  return exit_of(outcome, folder.path(), lost, console);
}

}  // namespace app
