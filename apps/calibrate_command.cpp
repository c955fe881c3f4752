#include "apps/calibrate_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/attempts.hpp"
#include "apps/calibration_json.hpp"
#include "apps/calibration_report.hpp"
#include "apps/calibration_words.hpp"
#include "apps/interrupt.hpp"
#include "apps/job.hpp"
#include "apps/json_text.hpp"
#include "apps/read_option.hpp"
#include "apps/run_location.hpp"
#include "apps/scene_builder.hpp"
#include "apps/scene_file.hpp"
#include "apps/scene_text.hpp"
#include "apps/terminal_line.hpp"
#include "libmpm/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer =
    "What is free is scaled: each parameter is a factor on the values in the scene, between a twentieth and "
    "twenty\ntimes, and may stand for several settings, which keep their ratios:\n"
    "  mortar.tensile_scale                  a key of the scene (phases. may be left out)\n"
    "  tensile_scale                         that property of all phases\n"
    "  mortar.cohesion+itz.cohesion          several keys together\n"
    "  mortar.young=10 GPa..30 GPa           with bounds, for the first of its settings\n"
    "By default tensile_scale is fitted to a peak stress, young to a strain at the peak, both to both, and\n"
    "weibull_modulus with them to a curve. Strengths and moduli that grow by one factor raise the stress by "
    "it "
    "and\nleave the strain, so that both follow from a peak; more needs a curve.\n"
    "CURVE.csv has a header with units and cells between commas: strain,stress_MPa (strain_microstrain and "
    "strain_%,\nstress_Pa, stress_kPa and stress_GPa do too); further columns are skipped, so the curve.csv "
    "of a run "
    "will do.\n"
    "The folder gets scene.toml, the scene with what was fitted, calibration.json and report.html.\n"
    "Example: a peak of 1.75 MPa at 75 microstrain, the strength of the ITZ in its ratio to that of the "
    "mortar\n"
    "  mesopix calibrate data/two_aggregates.toml --peak-stress \"1.75 MPa\" --peak-strain 75e-6";

Resolved resolve_scene(const std::string& input, const std::vector<Assignment>& given) {
  if (kind_of_input(input) != InputKind::scene)
    throw Rejected(Exit::usage, complaint("SCENE", input, "must be a scene, scene.toml",
                                          "mesopix simulate INPUT --print-scene writes one"));
  return resolve(read_scene_file(input), given);
}

void check_loading(const mpm::Scene& scene) {
  if (scene.loading.direction != mpm::Direction::none) return;
  throw Rejected(Exit::data, complaint("loading.direction", "none",
                                       "must be tension or compression: a peak is that of a "
                                       "stress-strain curve between platens"));
}

specimen::Specimen specimen_of(const Settings& settings, Console& console) {
  Prepared prepared = prepare_cells(settings);
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  return std::move(prepared.specimen);
}

Calibration fit(const CalibrationTask& task, Console& console) {
  const InterruptGuard guard;
  TerminalLine line(console.err, console.err_is_terminal && !console.quiet);
  line.show(fmt::format("the scene as it is, {} seeds", task.seeds));
  return calibrate(
      task, [&] { return guard.interrupted(); },
      [&](const Calibration& so_far) { line.show(evaluation_text(task, so_far)); });
}

/// Every file is tried, whatever became of the others.   @return what the disk did not take.
Attempts write_calibration(const fs::path& folder, const CalibrationTask& task,
                           const Calibration& calibration) {
  const std::string toml = scene_text(calibration.settings, Extent::whole, folder);
  Attempts attempt;
  const auto write = [&](const char* name, const std::string& text) {
    attempt([&] { mpm::replace_file((folder / name).string(), text); });
  };
  write("scene.toml", toml);
  write("calibration.json", json_text(calibration_json(task, calibration)));
  write("report.html", calibration_html(task, calibration, "Calibration: " + task.settings.title, toml));
  return attempt;
}

/// @throws Rejected when the target was not met.
Exit exit_of(const CalibrationTask& task, const Calibration& calibration, const fs::path& folder,
             Console& console) {
  if (calibration.end == SearchEnd::stopped) {
    console.say("interrupted; the best so far is kept");
    return Exit::interrupted;
  }
  if (const std::string unmet = why_not_met(task, calibration); !unmet.empty())
    throw Rejected(Exit::data, complaint("calibrate", unmet, "what was found is in " + folder.string()));
  return Exit::ok;
}

}  // namespace

CalibrateCommand::CalibrateCommand(CLI::App& program)
    : Command(program, "calibrate", "Fit parameters of a scene to a measured peak or curve", footer),
      settings_(options(), {{"phases"},
                            {"specimen", "generate", "convert", "itz", "loading", "damage", "solver",
                             "motion", "handover", "output"},
                            {}}) {
  options().add_option("SCENE", input_, "scene.toml, where the search begins")->type_name("");
  options()
      .add_option("--peak-stress", peak_stress_, "to be met by the mean of the seeds")
      ->type_name("PRESSURE");
  options()
      .add_option("--peak-strain", peak_strain_,
                  "strain of the platens at that stress, 75e-6 or \"75 microstrain\"")
      ->type_name("NUMBER");
  options()
      .add_option("--target", curve_, "whole curve to be met, in place of a peak")
      ->type_name("CURVE.csv");
  options().add_option("--free", free_, "what may change, see below")->type_name("PARAMETER,...");
  options()
      .add_option("--seeds", seeds_,
                  "runs of each set of parameters, with damage.seed and those after it [4]")
      ->type_name("N");
  options()
      .add_option("--tolerance", tolerance_, "misfit at which the search ends [0.5 %]")
      ->type_name("NUMBER");
  options()
      .add_option("--max-evaluations", evaluations_, "sets of parameters to try at most [100]")
      ->type_name("N");
  options().add_option("-o,--output", output_, "folder [runs/SCENE-calibration, ...]")->type_name("DIR");
  options().add_flag("--overwrite", overwrite_, "write into a folder that is not empty");
  options().add_flag("--json", json_, "calibration.json on standard output too");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

std::vector<std::string> CalibrateCommand::prepare(const std::vector<std::string>& arguments) {
  return settings_.take_phase_options(arguments);
}

Target CalibrateCommand::read_target() const {
  const bool peak = !peak_stress_.empty() || !peak_strain_.empty();
  if (peak == !curve_.empty())
    throw Rejected(Exit::usage,
                   complaint("--target", peak ? "given beside a peak" : "no target is given",
                             "a target is --peak-stress, --peak-strain or both, or --target CURVE.csv"));
  Target target;
  if (!curve_.empty()) target.curve = read_target_curve(curve_);
  if (!peak_stress_.empty())
    target.peak_stress =
        read_option("--peak-stress", peak_stress_, Quantity{Dimension::pressure, above(0), {}});
  if (!peak_strain_.empty())
    target.peak_strain =
        read_option("--peak-strain", peak_strain_, Quantity{Dimension::ratio, inside(0, 1), {}});
  return target;
}

void CalibrateCommand::read_numbers(CalibrationTask& task) const {
  task.seeds = read_option("--seeds", seeds_, Integer<>{{between(1, 1000), {}}});
  task.evaluations = read_option("--max-evaluations", evaluations_, Integer<>{{between(1, 100000), {}}});
  task.tolerance = read_option("--tolerance", tolerance_, Quantity{Dimension::ratio, inside(0, 1), {}});
}

std::string CalibrateCommand::wanted_free(const Target& target) const {
  if (!free_.empty()) return free_;
  if (!target.curve.empty()) return "tensile_scale,young,weibull_modulus";
  if (!target.peak_strain) return "tensile_scale";
  return target.peak_stress ? "tensile_scale,young" : "young";
}

Exit CalibrateCommand::run(Console& console) {
  console.quiet = quiet_;
  if (input_.empty())
    throw Rejected(Exit::usage, complaint("SCENE", "missing", "", "mesopix calibrate SCENE"));
  const Target target = read_target();
  Resolved resolved = resolve_scene(input_, settings_.assignments());
  console.origins = resolved.origins;
  Settings& settings = resolved.settings;
  check_loading(settings.scene);
  settle_source(settings);
  if (settings.title.empty()) settings.title = fs::path(input_).stem().string();
  const specimen::Specimen specimen = specimen_of(settings, console);
  const mpm::Scene scene = build_scene(specimen, settings);
  mpm::validate(scene);
  CalibrationTask task{settings, specimen, target, parse_free(wanted_free(target), settings, scene)};
  read_numbers(task);
  const FreshFolder folder(
      make_run_folder(output_, fs::path(input_).stem().string() + "-calibration", overwrite_));
  const Calibration calibration = fit(task, console);
  if (calibration.history.empty()) {
    console.say("interrupted before anything was found");
    return Exit::interrupted;
  }
  const Attempts written = write_calibration(folder.path(), task, calibration);
  for (const std::string& line : outcome_lines(task, calibration)) console.say(line);
  if (json_) console.out << json_text(calibration_json(task, calibration));
  written.conclude();
  console.say("wrote " + folder.path().string());
  return exit_of(task, calibration, folder.path(), console);
}

}  // namespace app
