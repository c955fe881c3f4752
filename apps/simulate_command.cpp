#include "apps/simulate_command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "apps/explanation.hpp"
#include "apps/interrupt.hpp"
#include "apps/output/load_words.hpp"
#include "apps/progress_line.hpp"
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

Outcome solve(const mpm::Scene& scene, Console& console) {
  const InterruptGuard guard;
  ProgressLine line(console.err, scene, console.err_is_terminal && !console.quiet);
  try {
    return {mpm::simulate(scene,
                          [&](const mpm::Progress& progress) {
                            line.show(progress);
                            return !guard.interrupted();
                          }),
            {}};
  } catch (const mpm::Diverged& diverged) {
    return {diverged.result, diverged.what()};
  }
}

/// Share of the energy put in that the ledger may miss without a word. Points that move lose more to the
/// grid, and can lose it all in the end where rubble is ground.
double tolerated_energy_error(const mpm::Scene& scene) {
  return scene.kinematics == mpm::Kinematics::small_strain ? 0.01 : 0.1;
}

/// What keeps more of the energy than the scene does.
std::string less_dissipation(const mpm::Scene& scene) {
  const mpm::Motion& motion = scene.motion;
  if (motion.transfer == mpm::Transfer::apic || motion.flip_ratio < 1)
    return "motion.transfer = \"flip\" with motion.flip_ratio = 1 loses less";
  if (motion.scheme == mpm::Scheme::usl) return "motion.scheme = \"musl\" or \"usf\" loses less";
  return "a smaller solver.cfl loses less";
}

std::string energy_note(const mpm::Result& result, const mpm::Scene& scene) {
  const std::string put_in = output::has_platens(scene) ? "the platen work" : "the energy of the flight";
  if (scene.damage.crack_closure == mpm::CrackClosure::clipped)
    return fmt::format(
        "the ledger of energies is off by {:.2g} % of {}; damage.crack_closure = \"clipped\" "
        "does not keep energy, \"unilateral\" does",
        100 * result.energy_error, put_in);
  if (scene.kinematics == mpm::Kinematics::small_strain)
    return fmt::format("the ledger of energies is off by {:.2g} % of {}; try a smaller solver.cfl",
                       100 * result.energy_error, put_in);
  return fmt::format(
      "{:.2g} % of {} was lost to numerical dissipation, as moving points average velocities "
      "through the grid; {}",
      100 * result.energy_error, put_in, less_dissipation(scene));
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

/// What the run itself leaves to be noted.
void note_outcome(const Outcome& outcome, Job& job, Console& console) {
  if (!outcome.divergence.empty()) {
    job.notes.push_back(outcome.divergence);
  } else if (outcome.result.energy_error > tolerated_energy_error(job.scene)) {
    job.notes.push_back(energy_note(outcome.result, job.scene));
    const bool expected = job.scene.kinematics != mpm::Kinematics::small_strain;
    console.say((expected ? "note: " : "warning: ") + job.notes.back());
  }
}

/// @throws Rejected when the physics went wrong.
Exit exit_of(const Outcome& outcome, const fs::path& folder, Console& console) {
  if (!outcome.divergence.empty())
    throw Rejected(Exit::data,
                   complaint("simulate", outcome.divergence, "what was computed is in " + folder.string()));
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
  options().add_flag("--json", json_, "summary as JSON on standard output");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

std::vector<std::string> SimulateCommand::prepare(const std::vector<std::string>& arguments) {
  return settings_.take_phase_options(arguments);
}

Exit SimulateCommand::run(Console& console) {
  console.quiet = quiet_;
  if (input_.empty())
    throw Rejected(Exit::usage, complaint("INPUT", "missing", "", "mesopix simulate INPUT"));
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
  const FreshFolder folder(make_run_folder(output_, fs::path(input_).stem(), overwrite_));
  const Outcome outcome = solve(job.scene, console);
  note_outcome(outcome, job, console);
  const std::string toml = scene_text(job.settings, Extent::whole, folder.path());
  const RunRecord record{job.specimen,       job.scene, outcome.result, toml, specimen::sha256_of_text(toml),
                         job.settings.title, job.notes};
  write_run(folder.path(), record);
  if (json_)
    console.out << summary(record).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  else
    console.say(result_text(outcome.result, job.scene));
  console.say("wrote " + folder.path().string());
  return exit_of(outcome, folder.path(), console);
}

}  // namespace app
