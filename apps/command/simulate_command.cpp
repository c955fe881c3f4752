#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command/command.hpp"
#include "apps/command/scene_command.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/run_length.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/run/run_task.hpp"
#include "apps/run/solving.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* simulate_footer =
    "The settings of the specimen are options too, by their keys: --generate.fraction 0.4, --convert.width "
    "\"150 mm\";\nsee mesopix generate --help and mesopix convert --help. --print-scene shows all of them as "
    "a scene.\n"
    "Ctrl-C, SIGTERM or SIGHUP ends a run with exit code 75; it goes on, on as many threads as you like, "
    "with "
    "--resume.\n"
    "Example: tension until the stress has dropped to 20 % of its peak; on with it after Ctrl-C; all of it "
    "from "
    "a file\n"
    "  mesopix simulate specimen.h5 --velocity \"0.02 m/s\" --stop-drop 0.2 --mortar.tensile-scale \"12 "
    "MPa\" -o run\n"
    "  mesopix simulate --resume run\n"
    "  mesopix simulate data/two_aggregates.toml --frames 40";

/// "at 0.1 m/s, CFL 0.5 and double precision".
std::string choice_text(const mpm::Scene& scene) {
  if (scene.method == mpm::SolverMethod::quasi_static)
    return fmt::format("by no rate, but without inertia (--method quasi_static --event-tolerance {})",
                       output::concise(scene.event_tolerance, 4));
  return fmt::format("at {} m/s, CFL {} and {} precision", output::concise(scene.loading.velocity, 4),
                     output::concise(scene.cfl, 4),
                     scene.precision == mpm::Precision::single ? "single" : "double");
}

/// Gives the job the rate, step and precision that the tolerance asks for, or the method without inertia.
/// @return their error.
output::ErrorEstimate meet(double tolerance, Job& job, Console& console, const InterruptGuard& guard) {
  const Tolerated found = meet_tolerance(job.scene, tolerance, second_run(console, guard));
  require_met(found, tolerance, "--tolerance");
  adopt(found, job);
  console.say(fmt::format("a tolerance of {} % is met {}, found in {:.2f} s",
                          output::concise(100 * tolerance), choice_text(found.scene), found.wall_time));
  return found.estimate;
}

class SimulateCommand : public SettingsCommand {
 public:
  explicit SimulateCommand(CLI::App& program)
      : SettingsCommand(program, "simulate", "Break a specimen, and write what happened into a folder",
                        simulate_footer, offer_of_simulate()) {
    option("[INPUT]", input_, "specimen.h5, scene.toml or picture",
           file_form(picture_endings({"h5", "toml"})));
    folder_and_overwrite("runs/INPUT, runs/INPUT-2, ...");
    flag("--print-scene", print_scene_, "print the resolved scene, and do no more");
    flag("--explain", explain_,
         "print what the run computes, what it leaves out and what that saves, and do no more");
    flag("--estimate-error", estimate_error_,
         "say how wrong the peak may be, from runs without inertia and with another step, precision and "
         "pixel size");
    option(
        "--tolerance", tolerance_,
        "choose the rate, the step and the precision, or the method without inertia, that keep the error of "
        "the peak stress below this, "
        "e.g. \"1 %\"",
        text_form("RATIO"));
    option("--checkpoint-every", checkpoint_every_,
           "wall time after which a run is kept to go on from, e.g. \"60 s\"; no part of the scene",
           QuantityCodec{Dimension::time}.form());
    option("--resume", resume_,
           "go on with the run in a folder, from its last checkpoint; the result is the same to the last bit",
           folder_form());
    flag("--serve", serve_,
         "show the report in a browser on this machine while the run goes on, with a button that "
         "stops it; the address is printed");
    option("--port", port_, "of --serve on 127.0.0.1 [any that is free]", QuantityCodec().form());
    json_and_quiet("summary as JSON on standard output");
  }

  Exit run(Console& console) override {
    check_options();
    return resume_.empty() ? begin(console) : go_on(console);
  }

 private:
  void check_options() const {
    const char* error = !tolerance_.empty() ? "--tolerance" : estimate_error_ ? "--estimate-error" : nullptr;
    const char* asked = error != nullptr ? error : serve_ ? "--serve" : nullptr;
    const auto refuse = [](const char* option, const char* other) {
      throw Rejected(Exit::usage, option, std::string("given with ") + other, "", "give one of the two");
    };
    if (!resume_.empty()) {
      const char* other = !input_.empty()    ? "INPUT"
                          : !output_.empty() ? "--output"
                          : overwrite_       ? "--overwrite"
                          : print_scene_     ? "--print-scene"
                          : explain_         ? "--explain"
                                             : error;
      if (other != nullptr) refuse("--resume", other);
      return;
    }
    require(input_, "INPUT", "mesopix simulate INPUT");
    const char* other = explain_                                 ? "--explain"
                        : print_scene_                           ? "--print-scene"
                        : !tolerance_.empty() && estimate_error_ ? "--estimate-error"
                                                                 : nullptr;
    if (asked != nullptr && other != nullptr) refuse(asked, other);
  }

  /// Of the live view, where it was asked for; 0 = any that is free.
  [[nodiscard]] std::optional<int> port() const {
    if (!serve_ && !port_.empty())
      throw Rejected(Exit::usage, "--port", port_, "is for --serve, which is not given", "add --serve");
    if (!serve_) return std::nullopt;
    return port_.empty() ? 0 : read_option("port", port_, IntegerCodec<int>{between(1, 65535)});
  }

  [[nodiscard]] double tolerance() const {
    return read_option("tolerance", tolerance_, QuantityCodec{Dimension::ratio, inside(0, 1)});
  }

  /// Wall time between checkpoints [s], where it was given.
  [[nodiscard]] std::optional<double> checkpoint_every() const {
    if (checkpoint_every_.empty()) return std::nullopt;
    return read_option("checkpoint-every", checkpoint_every_, QuantityCodec{Dimension::time, above(0)});
  }

  /// What stops a run of a scene is told with all else that is wrong in its file.
  /// @throws Rejected, from within a handler of what stopped it.
  [[noreturn]] void refuse_all(const Console& console) const {
    Rejected refusal = refusal_of(std::current_exception(), console.locate);
    if (refusal.code != Exit::data || kind_of_input(input_) != InputKind::scene) throw refusal;
    std::vector<Complaint> all = refusal.complaints;
    const auto is_known = [&](const Complaint& other) {
      return std::any_of(all.begin(), all.end(), [&](const Complaint& one) {
        return one.field == other.field || other.field.starts_with(one.field + ".");
      });
    };
    const std::vector<Assignment> given = settings_.assignments();
    const auto is_given = [&](const Complaint& other) {
      return std::any_of(given.begin(), given.end(),
                         [&](const Assignment& one) { return one.key == other.field; });
    };
    for (const Complaint& other : check_file(input_).complaints)
      if (!is_known(other) && !is_given(other)) all.push_back(other);
    throw Rejected(refusal.code, std::move(all));
  }

  [[nodiscard]] Resolved resolve_or_refuse(Console& console) const try {
    Resolved resolved = resolve_input("INPUT", input_, settings_.assignments());
    console.locate = located_by(resolved.origins);
    settle_source(resolved.settings);
    return resolved;
  } catch (const std::exception&) {
    refuse_all(console);
  }

  [[nodiscard]] Job make_or_refuse(Settings settings, Console& console) const try {
    return make_job(std::move(settings), console);
  } catch (const std::exception&) {
    refuse_all(console);
  }

  [[nodiscard]] Exit begin(Console& console) {
    const std::optional<int> port = this->port();
    const std::optional<double> wanted = tolerance_.empty() ? std::nullopt : std::optional(tolerance());
    RunRemarks remarks;
    remarks.estimate_error = estimate_error_;
    remarks.checkpoint_every = checkpoint_every().value_or(0);
    Resolved resolved = resolve_or_refuse(console);
    Settings& settings = resolved.settings;
    if (settings.title.empty()) settings.title = fs::path(input_).stem().string();
    if (print_scene_) {
      console.out << scene_text(settings, Extent::whole, fs::current_path());
      return Exit::ok;
    }
    const std::string left_out = note_of_left_out(resolved.origins, settings);
    if (!left_out.empty()) console.say("note: " + left_out);
    Job job = make_or_refuse(std::move(settings), console);
    if (!left_out.empty()) job.notes.push_back(left_out);
    if (explain_) {
      const mpm::Explanation explanation = mpm::explain(job.scene);
      console.out << (json_ ? json_text(explanation_json(explanation)) : explanation_text(explanation));
      return Exit::ok;
    }
    if ((estimate_error_ || wanted) && !output::has_platens(job.scene))
      throw Rejected(Exit::usage, wanted ? "--tolerance" : "--estimate-error", "there are no platens",
                     "needs a test in tension or compression");
    if (wanted && job.scene.method == mpm::SolverMethod::quasi_static)
      throw Rejected(Exit::usage, "--tolerance", tolerance_, "is for explicit runs",
                     "choose --event-tolerance");
    if (source_of(job.settings) == Source::picture && !resolved.origins.contains("convert.pixels"))
      refuse_unasked_length(length_of(job.scene), job.specimen.mask.labels.cols);
    const FreshFolder folder(make_run_folder(output_, fs::path(input_).stem(), overwrite_));
    const InterruptGuard guard;
    try {
      if (wanted) remarks.tolerated = meet(*wanted, job, console, guard);
    } catch (const NoEstimate& failed) {
      throw Rejected(failed.interrupted ? Exit::interrupted : Exit::data,
                     complaint("--tolerance", "not met, " + failed.why, "", "nothing was written"));
    }
    remarks.notes = job.notes;
    std::string toml = scene_text(job.settings, Extent::whole, folder.path());
    return carry_out(
        {std::move(job), folder.path(), std::move(toml), std::move(remarks), std::nullopt, port, json_},
        guard, console);
  }

  [[nodiscard]] Exit go_on(Console& console) {
    const std::optional<double> every = checkpoint_every();
    const std::optional<int> port = this->port();
    std::optional<RunTask> task = task_that_goes_on(resume_, settings_.assignments(), console);
    if (!task) return Exit::ok;
    task->json = json_;
    task->port = port;
    if (every) task->remarks.checkpoint_every = *every;
    const InterruptGuard guard;
    return carry_out(std::move(*task), guard, console);
  }

  std::string input_;
  bool print_scene_ = false;
  bool explain_ = false;
  bool estimate_error_ = false;
  std::string tolerance_;
  std::string checkpoint_every_;
  std::string resume_;
  bool serve_ = false;
  std::string port_;
};

}  // namespace

CommandPointer simulate_command(CLI::App& parent) { return std::make_unique<SimulateCommand>(parent); }

}  // namespace app
