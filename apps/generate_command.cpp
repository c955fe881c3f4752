#include "apps/generate_command.hpp"

#include <nlohmann/json.hpp>

#include "apps/scene_file.hpp"
#include "apps/specimen_output.hpp"
#include "apps/specimen_report.hpp"
#include "apps/specimen_source.hpp"

namespace app {
namespace {

constexpr const char* footer =
    "Example: a specimen of 100 mm with 40 % of aggregates between 4 and 16 mm\n"
    "  mesopix generate --width \"100 mm\" --height \"100 mm\" --fraction 0.4 --d-min \"4 mm\" --d-max \"16 "
    "mm\" "
    "-o specimen.h5\n"
    "then\n"
    "  mesopix simulate specimen.h5";

void refuse_other_source(const Resolved& resolved) {
  const Source source = source_of(resolved.settings);
  if (source != Source::file && source != Source::picture) return;
  const bool picture = source == Source::picture;
  throw Rejected(Exit::data, locate(resolved.origins,
                                    complaint(picture ? "specimen.picture" : "specimen.file", "given",
                                              "generate draws ellipses",
                                              picture ? "use mesopix convert" : "it is a specimen already")));
}

}  // namespace

GenerateCommand::GenerateCommand(CLI::App& program)
    : Command(program, "generate", "Draw random or listed ellipses as a specimen", footer),
      settings_(
          options(),
          {{"specimen", "generate", "itz"}, {}, {"specimen.file", "specimen.picture", "specimen.sha256"}}) {
  options().add_option("[SCENE]", scene_, "scene.toml whose specimen to draw")->type_name("");
  options()
      .add_option("-o,--output", output_,
                  "specimen file (.h5) or label picture (.png, .tif, .bmp, .pgm) [specimen.h5]")
      ->type_name("FILE");
  options().add_flag("--json", json_, "figures as JSON on standard output");
  options().add_flag("-q,--quiet", quiet_, "say nothing but errors");
}

std::vector<std::string> GenerateCommand::prepare(const std::vector<std::string>& arguments) {
  return settings_.take_phase_options(arguments);
}

Exit GenerateCommand::run(Console& console) {
  console.quiet = quiet_;
  check_output(output_, scene_);
  const SceneFile scene = scene_.empty() ? SceneFile() : read_scene_file(scene_);
  Resolved resolved = resolve(scene, settings_.assignments());
  console.origins = resolved.origins;
  refuse_other_source(resolved);
  settle_source(resolved.settings);
  const Prepared prepared = prepare_specimen(resolved.settings);
  const bool random = source_of(resolved.settings) == Source::generated;
  const specimen::Grading target = random ? packing_options(resolved.settings).grading : specimen::Grading();
  const auto files = write_specimen_output(output_, prepared.specimen);
  report_specimen(console, json_, prepared, specimen_json(prepared.specimen, target), files);
  return Exit::ok;
}

}  // namespace app
