#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/calibrate/calibration_folder.hpp"
#include "apps/calibrate/calibration_report.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/markup.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* calibrate_footer =
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
    "strain_%,\nstress_Pa, stress_kPa and stress_GPa do too, and so does \"stress (MPa)\"); further columns "
    "are skipped, so the curve.csv "
    "of a run "
    "will do.\n"
    "The folder gets scene.toml, the scene with what was fitted, calibration.json and report.html.\n"
    "Example: a peak of 1.75 MPa at 75 microstrain, the strength of the ITZ in its ratio to that of the "
    "mortar\n"
    "  mesopix calibrate data/two_aggregates.toml --peak-stress \"1.75 MPa\" --peak-strain 75e-6";

Calibration fit(const CalibrationTask& task, Console& console) {
  const InterruptGuard guard;
  TerminalLine line(console);
  line.show(fmt::format("the scene as it is, {} seeds", task.seeds));
  return calibrate(
      task, [&] { return guard.interrupted(); },
      [&](const Calibration& so_far) { line.show(evaluation_text(task, so_far)); });
}

/// @throws Rejected when the target was not met.
Exit exit_of(const CalibrationTask& task, const Calibration& calibration, const fs::path& folder,
             Console& console) {
  if (calibration.end == SearchEnd::stopped) {
    console.say("interrupted; the best so far is kept");
    return Exit::interrupted;
  }
  if (const std::string unmet = why_not_met(task, calibration); !unmet.empty())
    throw Rejected(Exit::data, "calibrate", unmet, "what was found is in " + folder.string());
  return Exit::ok;
}

class CalibrateCommand : public SettingsCommand {
 public:
  explicit CalibrateCommand(CLI::App& program)
      : SettingsCommand(program, "calibrate", "Fit parameters of a scene to a measured peak or curve",
                        calibrate_footer, offer_of_calibrate()) {
    option("SCENE", input_, "scene.toml, where the search begins", file_form({"toml"}));
    option("--peak-stress", wish_.peak_stress, "to be met by the mean of the seeds",
           QuantityCodec{Dimension::pressure}.form());
    option("--peak-strain", wish_.peak_strain,
           "strain of the platens at that stress, 75e-6 or \"75 microstrain\"", QuantityCodec().form());
    option("--target", wish_.curve, "whole curve to be met, in place of a peak",
           file_form({"csv"}, "CURVE.csv"));
    option("--free", wish_.free, "what may change, see below", text_form("PARAMETER,..."));
    option("--seeds", wish_.seeds, "runs of each set of parameters, with damage.seed and those after it [4]",
           WholeNumberCodec().form());
    option("--tolerance", wish_.tolerance, "misfit at which the search ends [0.5 %]", QuantityCodec().form());
    option("--max-evaluations", wish_.evaluations, "sets of parameters to try at most [100]",
           WholeNumberCodec().form());
    folder_and_overwrite("runs/SCENE-calibration, ...");
    json_and_quiet("calibration.json on standard output too");
  }

  Exit run(Console& console) override {
    require(input_, "SCENE", "mesopix calibrate SCENE");
    Target target = read_target(wish_);
    Resolved resolved = resolve_scene(input_, settings_.assignments());
    console.locate = located_by(resolved.origins);
    Settings& settings = resolved.settings;
    check_loading(settings.scene);
    settle_source(settings);
    if (settings.title.empty()) settings.title = fs::path(input_).stem().string();
    if (const std::string note = note_of_left_out(resolved.origins, settings); !note.empty())
      console.say("note: " + note);
    const Job job = make_job(std::move(settings), console);
    if (const std::string doubt = doubt_of(target); !doubt.empty()) console.warn(doubt);
    const CalibrationTask task = make_task(job, std::move(target), wish_);
    if (!console.quiet)
      if (const std::string length = announcement(task); !length.empty()) console.say(length);
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

 private:
  std::string input_;
  CalibrationWish wish_;
};

}  // namespace

CommandPointer calibrate_command(CLI::App& parent) { return std::make_unique<CalibrateCommand>(parent); }

}  // namespace app
