#include "apps/twin_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "apps/input.hpp"
#include "apps/interrupt.hpp"
#include "apps/read_option.hpp"
#include "apps/run_location.hpp"
#include "apps/specimen_source.hpp"
#include "apps/terminal_line.hpp"
#include "apps/twin_folder.hpp"
#include "apps/twin_words.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* footer =
    "PICTURE is all that convert reads, with its options, since the scale must be known; or a specimen.h5, "
    "or a\n"
    "scene.toml. Sizes, aspect ratios and directions of its aggregates are measured, and as many random ones "
    "drawn\n"
    "from them as fill the same fraction, at random places. How far fraction, sizes, neighbours and "
    "two-point\n"
    "probability S2 of the twins are off is told beside their scatter.\n"
    "The folder gets original.h5, twin_001.h5, ... with their previews, statistics.csv, statistics.json and\n"
    "report.html; scene.toml, which breaks the first twin; and study.toml, with which mesopix study breaks "
    "them "
    "all.\n"
    "Example: fifty specimens like a photograph that is 150 mm wide\n"
    "  mesopix twin photo.jpg --width \"150 mm\" --pixels 300 -n 50";

Quantity length(Bounds bounds, std::optional<Word> word = {}) { return {Dimension::length, bounds, word}; }

/// 0 where none was given.
double optional_length(const char* option, const std::string& text) {
  return text.empty() ? 0 : read_option(option, text, length(above(0)));
}

/// A specimen without inclusions whose labels have aggregate: a file that another program wrote.
void require_inclusions(const specimen::Specimen& original, const std::string& input) {
  if (!original.inclusions.empty() || specimen::count_labels(original.mask)[specimen::phase::aggregate] == 0)
    return;
  throw Rejected(Exit::data,
                 complaint(input, "has aggregate but tells of no inclusions", "twins need their outlines",
                           "export its labels as a picture and give that"));
}

std::vector<TwinRecord> make(const TwinTask& task, const fs::path& folder, const InterruptGuard& guard,
                             Console& console) {
  TerminalLine line(console.err, console.err_is_terminal && !console.quiet);
  const auto show = [&](std::size_t done) { line.show(fmt::format("{} of {} twins", done, task.count)); };
  show(0);
  return make_twins(
      task, folder, [&] { return guard.interrupted(); }, show);
}

}  // namespace

TwinCommand::TwinCommand(CLI::App& program)
    : Command(program, "twin", "Draw random specimens that are like a picture", footer),
      settings_(options(),
                {{"convert", "itz"}, {"specimen", "generate"}, {"specimen.file", "specimen.picture"}}) {
  options()
      .add_option("PICTURE", input_, "picture, specimen.h5 or scene.toml of the original")
      ->type_name("");
  options().add_option("-n,--count", count_, "number of twins [10]")->type_name("N");
  options()
      .add_option("--seed", seed_, "of the first twin; the others have those after it [1]")
      ->type_name("N");
  options().add_option("--twin-width", width_, "of the twins [as the original]")->type_name("LENGTH");
  options().add_option("--twin-height", height_, "of the twins [as the original]")->type_name("LENGTH");
  options()
      .add_option("--twin-pixel-size", pixel_size_, "of the twins [as the original]")
      ->type_name("LENGTH");
  options()
      .add_option("--gap", gap_, "least distance of aggregates; auto = as those of the original keep [auto]")
      ->type_name("LENGTH|auto");
  options()
      .add_option("--border", border_,
                  "cut = that of a saw cut, which cuts aggregates; whole = a wall, which keeps them inside; "
                  "auto = as that of the original [auto]")
      ->type_name("auto|cut|whole");
  options().add_option("-o,--output", output_, "folder [runs/PICTURE-twins, ...]")->type_name("DIR");
  options().add_flag("--overwrite", overwrite_, "write into a folder that is not empty");
  options().add_flag("--json", json_, "statistics.json on standard output too");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

std::vector<std::string> TwinCommand::prepare(const std::vector<std::string>& arguments) {
  return settings_.take_phase_options(arguments);
}

specimen::TwinOptions TwinCommand::twin_options() const {
  using specimen::Border;
  const Choice<Border> border{{{"auto", Border::automatic}, {"cut", Border::cut}, {"whole", Border::whole}}};
  specimen::TwinOptions options;
  options.width = optional_length("--twin-width", width_);
  options.height = optional_length("--twin-height", height_);
  options.pixel_size = optional_length("--twin-pixel-size", pixel_size_);
  options.gap = read_option("--gap", gap_, length(at_least(0), Word{"auto", -1}));
  options.border = read_option("--border", border_, border);
  return options;
}

TwinTask TwinCommand::make_task(const Settings& settings, specimen::Specimen original) const {
  TwinTask task;
  task.name = fs::path(input_).stem().string();
  task.count = read_option("-n", count_, Integer<>{{between(1, 1000), {}}});
  task.seed = read_option("--seed", seed_, Integer<std::uint64_t>{{at_least(0), {}}});
  const specimen::TwinOptions options = twin_options();
  task.itz = source_of(settings) == Source::file ? original.itz : settings.itz;
  task.settings = settings;
  task.descriptors = specimen::describe(original);
  task.plan = specimen::plan_twins(task.descriptors, options);
  task.original = std::move(original);
  return task;
}

Exit TwinCommand::run(Console& console) {
  console.quiet = quiet_;
  if (input_.empty())
    throw Rejected(Exit::usage, complaint("PICTURE", "missing", "", "mesopix twin PICTURE"));
  (void)twin_options();
  Resolved resolved = resolve_input("PICTURE", input_, settings_.assignments());
  console.origins = resolved.origins;
  settle_source(resolved.settings);
  Prepared prepared = prepare_specimen(resolved.settings);
  require_inclusions(prepared.specimen, input_);
  const TwinTask task = make_task(resolved.settings, std::move(prepared.specimen));
  const FreshFolder folder(make_run_folder(output_, task.name + "-twins", overwrite_));
  const InterruptGuard guard;
  const std::vector<TwinRecord> twins = make(task, folder.path(), guard, console);
  if (twins.empty()) {
    console.say("interrupted before a twin was made");
    return Exit::interrupted;
  }
  const TwinStatistics statistics = write_twin_statistics(folder.path(), task, twins, prepared.notes);
  for (const std::string& note : statistics.notes) console.say("note: " + note);
  console.say(twins_text(task, twins.size()));
  for (const std::string& line : misfit_lines(task, statistics.misfit)) console.say(line);
  if (json_) console.out << statistics.json;
  console.say("wrote " + folder.path().string());
  if (twins.size() == static_cast<std::size_t>(task.count)) return Exit::ok;
  console.say("interrupted; the twins that were made are kept");
  return Exit::interrupted;
}

}  // namespace app
