#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/job/specimen_report.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/scene/input.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/text_parts.hpp"
#include "specimen/convert/convert.hpp"

namespace app {
namespace {

constexpr const char* convert_footer =
    "Example: a photograph that is 150 mm wide, cut into 300 columns of pixels\n"
    "  mesopix convert photo.jpg --width \"150 mm\" --pixels 300 -o specimen.h5";

/// Intersection over union with a label picture, phase by phase: how well the segmentation does, before
/// rings.
nlohmann::ordered_json compare(const specimen::LabelledMask& mask, const specimen::ConvertOptions& options,
                               const std::string& reference) {
  specimen::ConvertOptions labels;
  labels.method = specimen::Segmentation::labels;
  labels.label_phases = options.label_phases;
  labels.width = mask.width();
  labels.max_pixels = options.max_pixels;
  labels.crop = options.crop;
  labels.pixels = options.pixels;
  const auto wanted = specimen::convert_picture(reference, labels).segmented.mask;
  const auto shares = specimen::intersection_over_union(mask, wanted);
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (std::size_t label = 0; label < shares.size(); ++label)
    if (!std::isnan(shares[label]))
      result[label < mask.phases.size() ? mask.phases[label] : wanted.phases[label]] = shares[label];
  return result;
}

constexpr double seconds_a_pixel = 0.2e-6;  ///< of a picture without a given number of pixels [s]
constexpr double long_wait = 10;            ///< that is told beforehand [s]

class ConvertCommand : public SettingsCommand {
 public:
  explicit ConvertCommand(CLI::App& program)
      : SettingsCommand(program, "convert", "Turn a picture into a specimen", convert_footer,
                        offer_of_convert()) {
    option("PICTURE", input_, "PNG, TIFF, BMP, JPEG, PGM or PPM, or a scene.toml that names one",
           file_form(picture_endings({"toml"})));
    option("-o,--output", output_, "specimen file (.h5) or label picture [PICTURE with .h5]",
           file_form(picture_endings({"h5"})));
    option("--reference", reference_, "label picture to compare with: intersection over union per phase",
           file_form(picture_endings(), "LABELS"));
    json_and_quiet("figures as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(input_, "PICTURE", "mesopix convert PICTURE");
    Resolved resolved = resolve_picture(input_, settings_.assignments());
    console.locate = located_by(resolved.origins);
    settle_source(resolved.settings);
    const std::string picture = resolved.settings.specimen.picture;
    const std::string output =
        output_.empty() ? std::filesystem::path(picture).filename().replace_extension(".h5").string()
                        : output_;
    check_output(output, picture);
    const Prepared prepared = prepare_or_show_ways(console, resolved.settings);
    auto figures = specimen_json(prepared.specimen, {});
    if (!reference_.empty())
      figures["intersection_over_union"] =
          compare(prepared.segmentation, resolved.settings.convert, reference_);
    report_specimen(console, json_, prepared, figures,
                    write_specimen_output(output, prepared.specimen, prepared.photograph));
    if (!reference_.empty() && !json_)
      for (const auto& [phase, share] : figures["intersection_over_union"].items())
        console.say(fmt::format("  {:<12} IoU {:.4f}", phase, share.get<double>()));
    return Exit::ok;
  }

 private:
  /// A map that can be read in two ways is not converted; the commands for both are shown.
  Prepared prepare_or_show_ways(Console& console, const Settings& settings) const {
    try {
      return prepare_specimen(settings, [&](std::int64_t rows, std::int64_t cols) {
        const double seconds = seconds_a_pixel * static_cast<double>(rows) * static_cast<double>(cols);
        if (seconds >= long_wait)
          console.say(fmt::format("note: a picture of {} x {} pixels takes about {:.0f} s",
                                  output::grouped(cols), output::grouped(rows),
                                  10 * std::ceil(seconds / 10)));
      });
    } catch (const specimen::TwoReadings& two) {
      std::string ways;
      for (const std::string& phases : two.label_phases)
        ways += (ways.empty() ? "either: " : ", or: ") + command_with(phases);
      throw Rejected(Exit::data, two.field, two.value, two.allowed, ways);
    }
  }

  /// This command once more, with the phases of the labels.
  [[nodiscard]] std::string command_with(const std::string& label_phases) const {
    std::string command = "mesopix convert " + shell_word(input_);
    for (const Assignment& given : settings_.assignments())
      if (given.key != "convert.label_phases" && given.field.starts_with("--"))
        command += " " + given.field + " " + shell_word(given.written);
    command += " " + option_name("label-phases") + " " + shell_word(label_phases);
    if (!output_.empty()) command += " -o " + shell_word(output_);
    return command;
  }

  std::string input_;
  std::string reference_;
};

}  // namespace

CommandPointer convert_command(CLI::App& parent) { return std::make_unique<ConvertCommand>(parent); }

}  // namespace app
