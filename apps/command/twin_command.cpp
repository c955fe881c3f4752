#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "apps/job/specimen_source.hpp"
#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"
#include "apps/twin/twin_folder.hpp"
#include "apps/twin/twin_words.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* twin_footer =
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

std::vector<TwinRecord> make(const TwinTask& task, const fs::path& folder, const InterruptGuard& guard,
                             Console& console) {
  TerminalLine line(console);
  const auto show = [&](std::size_t done) { line.show(fmt::format("{} of {} twins", done, task.count)); };
  show(0);
  return make_twins(
      task, folder, [&] { return guard.interrupted(); }, show);
}

class TwinCommand : public SettingsCommand {
 public:
  explicit TwinCommand(CLI::App& program)
      : SettingsCommand(program, "twin", "Draw random specimens that are like a picture", twin_footer,
                        offer_of_twin()) {
    option("PICTURE", input_, "picture, specimen.h5 or scene.toml of the original",
           file_form(picture_endings({"h5", "toml"})));
    option("-n,--count", wish_.count, "number of twins [10]", WholeNumberCodec().form());
    option("--seed", wish_.seed, "of the first twin; the others have those after it [1]",
           WholeNumberCodec().form());
    option("--twin-width", wish_.width, "of the twins [as the original]",
           QuantityCodec{Dimension::length}.form());
    option("--twin-height", wish_.height, "of the twins [as the original]",
           QuantityCodec{Dimension::length}.form());
    option("--twin-pixel-size", wish_.pixel_size, "of the twins [as the original]",
           QuantityCodec{Dimension::length}.form());
    option("--gap", wish_.gap, "least distance of aggregates; auto = as those of the original keep [auto]",
           QuantityCodec{Dimension::length, {}, Word{"auto"}}.form());
    option("--border", wish_.border,
           "cut = that of a saw cut, which cuts aggregates; whole = a wall, which keeps them inside; "
           "auto = as that of the original [auto]",
           one_of({"auto", "cut", "whole"}));
    folder_and_overwrite("runs/PICTURE-twins, ...");
    json_and_quiet("statistics.json on standard output too");
  }

  Exit run(Console& console) override {
    require(input_, "PICTURE", "mesopix twin PICTURE");
    (void)twin_options(wish_);
    Resolved resolved = resolve_input("PICTURE", input_, settings_.assignments());
    console.locate = located_by(resolved.origins);
    settle_source(resolved.settings);
    Prepared prepared = prepare_specimen(resolved.settings);
    for (const std::string& doubt : specimen::doubts_of(prepared.specimen)) console.warn(doubt);
    const specimen::ItzOptions itz =
        source_of(resolved.settings) == Source::file ? prepared.specimen.itz : resolved.settings.itz;
    const TwinTask task = make_twin_task(wish_, input_, resolved.settings, itz, std::move(prepared.specimen));
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

 private:
  std::string input_;
  TwinWish wish_;
};

}  // namespace

CommandPointer twin_command(CLI::App& parent) { return std::make_unique<TwinCommand>(parent); }

}  // namespace app
