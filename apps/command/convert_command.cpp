#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "apps/edit/editing.hpp"
#include "apps/job/specimen_report.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/scene/input.hpp"
#include "apps/scene/stroke_list.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/text_parts.hpp"
#include "specimen/body/files.hpp"
#include "specimen/convert/convert.hpp"
#include "specimen/describe/agreement.hpp"

namespace app {
namespace {

constexpr const char* convert_footer =
    "Example: a photograph that is 150 mm wide, cut into 300 columns of pixels\n"
    "  mesopix convert photo.jpg --width \"150 mm\" --pixels 300 -o specimen.h5";

/// Figures of how well a segmentation agrees with a label picture or a map of instances, before rings.
nlohmann::ordered_json compare(const specimen::Segmented& found, const specimen::ConvertOptions& options,
                               const std::string& reference) {
  specimen::ConvertOptions labels;
  const bool is_taught = !options.strokes.empty() || !options.model.empty();
  if (!is_taught) labels.label_phases = options.label_phases;  // else they are of strokes
  labels.width = found.mask.width();
  labels.max_pixels = options.max_pixels;
  labels.crop = options.crop;
  labels.pixels = options.pixels;
  const specimen::Converted wanted = specimen::convert_picture(reference, labels);
  if (wanted.report.method != specimen::Segmentation::labels &&
      wanted.report.method != specimen::Segmentation::instances)
    throw Rejected(Exit::data, "--reference", reference, "must be a label picture or a map of instances",
                   "save it as PNG or TIFF, with a value for each phase or aggregate");
  const specimen::Agreement agreement = specimen::agreement_of(found, wanted.segmented);
  const auto& names = found.mask.phases.size() >= wanted.segmented.mask.phases.size()
                          ? found.mask.phases
                          : wanted.segmented.mask.phases;
  nlohmann::ordered_json overlap = nlohmann::ordered_json::object(), boundary = overlap;
  for (std::size_t label = 0; label < agreement.phases.size(); ++label) {
    const auto& of_phase = agreement.phases[label];
    if (!std::isnan(of_phase.intersection_over_union))
      overlap[names[label]] = of_phase.intersection_over_union;
    if (!std::isnan(of_phase.boundary)) boundary[names[label]] = of_phase.boundary;
  }
  nlohmann::ordered_json aggregates{
      {"matched", agreement.matched}, {"missed", agreement.missed}, {"extra", agreement.extra}};
  if (!std::isnan(agreement.panoptic_quality)) aggregates["panoptic_quality"] = agreement.panoptic_quality;
  return {{"intersection_over_union", overlap}, {"boundary_f", boundary}, {"aggregates_found", aggregates}};
}

void say_agreement(Console& console, const nlohmann::ordered_json& figures) {
  for (const auto& [phase, share] : figures["intersection_over_union"].items())
    console.say(fmt::format(
        "  {:<12} IoU {:.4f}{}", phase, share.get<double>(),
        figures["boundary_f"].contains(phase)
            ? fmt::format("   boundary F (2 px) {:.4f}", figures["boundary_f"][phase].get<double>())
            : ""));
  const auto& aggregates = figures["aggregates_found"];
  if (aggregates.contains("panoptic_quality"))
    console.say(
        fmt::format("  aggregates   panoptic quality {:.4f}: {} matched, {} missed, {} extra",
                    aggregates["panoptic_quality"].get<double>(), aggregates["matched"].get<std::int64_t>(),
                    aggregates["missed"].get<std::int64_t>(), aggregates["extra"].get<std::int64_t>()));
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
    option("--reference", reference_,
           "labels or instances to compare with: IoU and boundary F per phase, panoptic quality",
           file_form(picture_endings(), "LABELS"));
    option("--save-model", save_model_, "keep what the strokes taught, for further pictures with --model",
           file_form({"mesomodel"}, "MODEL"));
    flag("--edit", edit_,
         "draw strokes on a page in a browser on this machine, which shows what they teach; the address is "
         "printed");
    option("--port", port_, "of --edit on 127.0.0.1 [any that is free]", QuantityCodec().form());
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
    check_save_model(resolved.settings);
    if (!edit_ && !port_.empty())
      throw Rejected(Exit::usage, "--port", port_, "is for --edit, which is not given", "add --edit");
    if (edit_) return edit(console, std::move(resolved.settings), output);
    report(console, convert(console, resolved.settings, output));
    return Exit::ok;
  }

 private:
  /// What came of a picture, written already.
  struct Conversion {
    Prepared prepared;
    nlohmann::ordered_json figures;
    std::vector<std::string> files;
  };

  Conversion convert(Console& console, const Settings& settings, const std::string& output) const {
    Conversion done{prepare_or_show_ways(console, settings), {}, {}};
    const Prepared& prepared = done.prepared;
    done.figures = specimen_json(prepared.specimen, {});
    if (!reference_.empty())
      done.figures.update(compare(prepared.segmentation, settings.convert, reference_));
    if (!std::isnan(prepared.uncertain_share)) done.figures["uncertain"] = prepared.uncertain_share;
    done.files = write_specimen_output(output, prepared.specimen, prepared.photograph, prepared.uncertain);
    if (!save_model_.empty()) {
      specimen::replace_file(save_model_, std::as_bytes(std::span(prepared.model)));
      done.files.push_back(save_model_);
    }
    return done;
  }

  void report(Console& console, const Conversion& done) const {
    report_specimen(console, json_, done.prepared, done.figures, done.files);
    if (!reference_.empty() && !json_) say_agreement(console, done.figures);
  }

  [[nodiscard]] int port() const {
    return port_.empty() ? 0 : read_option("port", port_, IntegerCodec<int>{between(1, 65535)});
  }

  /// On a page, which makes specimens as often as the person wants.
  Exit edit(Console& console, Settings settings, const std::string& output) const {
    const int port = this->port();
    const std::string picture = settings.specimen.picture;
    const std::string file = strokes_file_for(picture, output);
    EditBeginning beginning = begin_to_edit(settings, settings_.assignments(), file);
    StrokeBook book(file, beginning.lines, beginning.picture.rows(), beginning.picture.cols());
    EditTask task{
        std::move(beginning.picture), std::filesystem::path(picture).filename().string(),
        settings.convert.crop, std::move(beginning.given),
        [this](const std::vector<Assignment>& given) { return resolve_picture(input_, given).settings; }};
    std::optional<Conversion> last;
    const Exit code = edit_picture(
        picture, std::move(task), std::move(book), port,
        [&](const EditSession::Wanted& wanted) { return make(console, wanted, output, last); }, console);
    if (json_ && last) report(console, *last);
    return code;
  }

  /// A specimen of the strokes of a page, as the command that is told makes it.
  Made make(Console& console, const EditSession::Wanted& wanted, const std::string& output,
            std::optional<Conversion>& last) const {
    const std::filesystem::path path(output);
    Made made;
    made.strokes = (path.parent_path() / (path.stem().string() + "_strokes.csv")).string();
    const std::string text = stroke_list_text(wanted.lines);
    specimen::replace_file(made.strokes, std::as_bytes(std::span(text)));
    std::vector<Assignment> given = wanted.given;
    given.push_back(given_as_option("convert.strokes", Kind::path, "--strokes", made.strokes));
    Settings settings = resolve_picture(input_, given).settings;
    settle_source(settings);
    last = convert(console, settings, output);
    last->files.push_back(made.strokes);
    if (!json_) report(console, *last);
    made.files = last->files;
    made.command = command_with(given, output);
    made.figures = last->figures;
    made.uncertain = last->prepared.uncertain_share;
    made.notes = last->prepared.notes;
    made.segmentation = std::move(last->prepared.segmentation);
    made.uncertain_at = std::move(last->prepared.uncertain);
    console.say("the same without the page: " + made.command);
    return made;
  }

  void check_save_model(const Settings& settings) const {
    if (save_model_.empty()) return;
    if (settings.convert.strokes.empty() && !edit_)
      throw Rejected(Exit::usage, "--save-model", save_model_, "needs strokes that teach a model",
                     "give --strokes STROKES");
    if (std::filesystem::path(save_model_).extension() != ".mesomodel")
      throw Rejected(Exit::usage, "--save-model", save_model_, "must end in .mesomodel");
  }

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
      for (const std::string& phases : two.label_phases) {
        std::vector<Assignment> given = settings_.assignments();
        std::erase_if(given, [](const Assignment& one) { return one.key == "convert.label_phases"; });
        given.push_back(
            given_as_option("convert.label_phases", Kind::list, option_name("label-phases"), phases));
        ways += (ways.empty() ? "either: " : ", or: ") + command_with(given, output_);
      }
      throw Rejected(Exit::data, two.field, two.value, two.allowed, ways);
    }
  }

  /// This command once more, with other settings.
  [[nodiscard]] std::string command_with(const std::vector<Assignment>& given,
                                         const std::string& output) const {
    std::string command = "mesopix convert " + shell_word(input_);
    for (const Assignment& one : given) {
      if (!one.field.starts_with("--")) continue;
      command += one.field.starts_with("--set ") ? " --set" : " " + one.field;
      if (one.field.starts_with("--set "))
        command += " " + shell_word(one.key + "=" + one.written);
      else if (find_field(one.key)->form.kind != Kind::boolean)
        command += " " + shell_word(one.written);
      else if (one.written != "true")
        command += "=" + one.written;
    }
    if (!output.empty()) command += " -o " + shell_word(output);
    return command;
  }

  std::string input_;
  std::string reference_;
  std::string save_model_;
  bool edit_ = false;
  std::string port_;
};

}  // namespace

CommandPointer convert_command(CLI::App& parent) { return std::make_unique<ConvertCommand>(parent); }

}  // namespace app
