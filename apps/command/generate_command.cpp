#include "apps/command/command.hpp"

#include <nlohmann/json.hpp>

#include "apps/job/specimen_report.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/scene/input.hpp"

namespace app {
namespace {

constexpr const char* generate_footer =
    "Example: a specimen of 100 mm with 40 % of aggregates between 4 and 16 mm\n"
    "  mesopix generate --width \"100 mm\" --height \"100 mm\" --fraction 0.4 --d-min \"4 mm\" --d-max \"16 "
    "mm\" "
    "-o specimen.h5\n"
    "then\n"
    "  mesopix simulate specimen.h5";

class GenerateCommand : public SettingsCommand {
 public:
  explicit GenerateCommand(CLI::App& program)
      : SettingsCommand(program, "generate", "Draw random or listed ellipses as a specimen", generate_footer,
                        offer_of_generate()) {
    option("[SCENE]", scene_, "scene.toml whose specimen to draw", file_form({"toml"}));
    output_ = "specimen.h5";
    option("-o,--output", output_,
           "specimen file (.h5) or label picture (.png, .tif, .bmp, .pgm) [specimen.h5]",
           file_form(picture_endings({"h5"})));
    json_and_quiet("figures as JSON on standard output");
  }

  Exit run(Console& console) override {
    check_output(output_, scene_);
    Resolved resolved = resolve_ellipses(scene_, settings_.assignments());
    console.locate = located_by(resolved.origins);
    settle_source(resolved.settings);
    const Prepared prepared = prepare_specimen(resolved.settings);
    const bool random = source_of(resolved.settings) == Source::generated;
    const specimen::Grading target =
        random ? packing_options(resolved.settings).grading : specimen::Grading();
    const auto files = write_specimen_output(output_, prepared.specimen);
    report_specimen(console, json_, prepared, specimen_json(prepared.specimen, target), files);
    return Exit::ok;
  }

 private:
  std::string scene_;
};

}  // namespace

CommandPointer generate_command(CLI::App& parent) { return std::make_unique<GenerateCommand>(parent); }

}  // namespace app
