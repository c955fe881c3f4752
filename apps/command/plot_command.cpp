#include "apps/command/command.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "apps/drawing/chart.hpp"
#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/drawing_files.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/run/run_location.hpp"
#include "apps/run/stress_plot.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/settings/codec.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double margin = 16;  ///< of paper [px]

constexpr const char* plot_footer =
    "Stress is that of the frame nearest to --at (mesopix simulate SCENE --frames 40), in MPa, tension "
    "positive.\n"
    "Components: yy along the loading, xx across it, xy; first and third, the largest and the smallest of "
    "the\n"
    "three principal stresses; mises. Failed points are black. Without --range the colours leave out the "
    "largest\n"
    "and the smallest hundredth of the values; warm colours are above zero, cool ones below.\n"
    "Examples:\n"
    "  mesopix plot runs/specimen --at 90%peak -o damage.pdf\n"
    "  mesopix plot runs/specimen --at 120e-6 --look colour -o damage.png\n"
    "  mesopix plot runs/specimen --what curve -o curve.svg\n"
    "  mesopix plot runs/specimen --what stress --component first --range \"0:5 MPa\" -o stress.pdf";

enum class What { damage, curve, stress };
enum class Palette { grey, colour };
using output::StressComponent;
enum class Format { png, svg, pdf };

template <class E>
E chosen(const char* option, const std::string& text,
         std::initializer_list<std::pair<const char*, E>> words) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) {
    if (text == name) return value;
    names.emplace_back(name);
  }
  throw Rejected(Exit::usage, option, text, "must be " + listed(names));
}

constexpr std::initializer_list<std::pair<const char*, StressComponent>> components{
    {"yy", StressComponent::yy},       {"xx", StressComponent::xx},       {"xy", StressComponent::xy},
    {"first", StressComponent::first}, {"third", StressComponent::third}, {"mises", StressComponent::mises}};

/// By the ending of the file.
Format format_of(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return chosen<Format>("the ending of -o", ending,
                        {{".png", Format::png}, {".svg", Format::svg}, {".pdf", Format::pdf}});
}

/// A strain, or a share of that at the peak: "120e-6", "0.5 %", "90%peak".
double strain_at(const std::string& text, const mpm::Result& result) {
  constexpr std::string_view peak = "peak";
  const QuantityCodec number{Dimension::ratio};
  if (!text.ends_with(peak)) return read_option("at", text, number);
  const double share = read_option("at", text.substr(0, text.size() - peak.size()), number);
  if (!(result.peak_strain > 0))
    throw Rejected(Exit::data, "--at", text, "the run has no peak", "give a strain, like 120e-6");
  return share * result.peak_strain;
}

/// Strains beyond the end of the run, or before its beginning, have no picture.
void check_reached(const std::string& text, double strain, const mpm::Result& result) {
  const double end = output::largest_strain(result);
  // A run ends where its last row is; what the reader typed for that has fewer digits.
  if (strain >= 0 && strain <= end * (1 + 1e-6)) return;
  const output::StrainUnit unit = output::strain_unit(result);
  throw Rejected(Exit::data, "--at", text,
                 "must be from 0 to " + output::rounded(unit.per_strain * end) + " " + unit.name +
                     ", where the run ended");
}

/// Of --at.
double reached_strain(const std::string& text, const mpm::Result& result) {
  const double strain = strain_at(text, result);
  check_reached(text, strain, result);
  return strain;
}

output::Drawing damage(const ReadRun& run, double strain, Palette look) {
  return output::damage_drawing(run.specimen.mask, run.result, strain,
                                look == Palette::grey ? output::grey_palette() : output::colour_palette(),
                                output::strain_words(run.result, strain, 0));
}

std::string bytes_of(const output::Drawing& drawing, Format format) {
  switch (format) {
    case Format::png:
      return output::png_of(drawing, 2.5, margin);
    case Format::svg:
      return output::vector_file(drawing, output::VectorFormat::svg, margin);
    case Format::pdf:
      break;
  }
  return output::vector_file(drawing, output::VectorFormat::pdf, margin);
}

class PlotCommand : public Command {
 public:
  explicit PlotCommand(CLI::App& program)
      : Command(program, "plot", "Draw damage, stress or the curve of a run for a paper or a slide",
                plot_footer) {
    option("RUN", run_, "folder of a run", folder_form());
    option("--what", what_, "what to draw [damage]", one_of({"damage", "stress", "curve"}));
    add("--at", at_, text_form("STRAIN"),
        "strain, or share of the peak strain, of damage or stress [100%peak]", {"damage", "stress"});
    add("--look", look_, one_of({"grey", "colour"}), "of damage; grey is as in the paper [grey]", {"damage"});
    add("--component", component_, one_of({"yy", "xx", "xy", "first", "third", "mises"}), "of stress [yy]",
        {"stress"});
    add("--range", range_, text_form("LOW:HIGH", {"auto"}),
        "of the colours of stress, as \"-5:5 MPa\" [auto]", {"stress"});
    option("-o,--output", output_, "the picture: .png, .svg or .pdf [WHAT.png]",
           file_form({"png", "svg", "pdf"}));
    json_and_quiet("the file and what it shows as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(run_, "RUN", "mesopix plot RUN");
    const What what = chosen<What>(
        "--what", what_, {{"damage", What::damage}, {"stress", What::stress}, {"curve", What::curve}});
    check_fit();
    const Palette look =
        chosen<Palette>("--look", look_, {{"grey", Palette::grey}, {"colour", Palette::colour}});
    const StressComponent component = chosen<StressComponent>("--component", component_, components);
    std::optional<output::ColourScale> range;
    if (range_ != "auto") range = read_range(range_);
    const std::string path = output_.empty() ? what_ + ".png" : output_;
    const Format format = format_of(path);
    const ReadRun run = read_run(run_);
    std::string words = "wrote " + path;
    nlohmann::ordered_json shown{{"files", {path}}, {"what", what_}};
    output::Drawing drawing;
    switch (what) {
      case What::damage:
        shown["strain"] = reached_strain(at_, run.result);
        drawing = damage(run, shown["strain"], look);
        break;
      case What::stress: {
        StressPlot plot = stress_plot(run, run_, reached_strain(at_, run.result), component, range);
        drawing = std::move(plot.drawing);
        words += ": " + plot.words;
        shown["frame"] = plot.words;
        break;
      }
      case What::curve:
        drawing = output::lay_out(output::stress_chart(run.record()), 608, 368);
        break;
    }
    mpm::replace_file(path, bytes_of(drawing, format));
    if (json_) console.out << json_text(shown);
    console.say(words);
    return Exit::ok;
  }

 private:
  void add(const char* name, std::string& text, Form form, const char* help, std::vector<std::string> fits) {
    special_.push_back({option(name, text, help, std::move(form)), std::move(fits)});
  }

  /// An option that changes nothing was meant for something else.
  void check_fit() const {
    for (const auto& [option, fits] : special_)
      if (option->count() > 0 && std::find(fits.begin(), fits.end(), what_) == fits.end())
        throw Rejected(Exit::usage, option->get_name(), option->as<std::string>(),
                       "changes nothing of --what " + what_ + "; is for " + listed(fits));
  }

  /// An option of some of the kinds of pictures.
  struct Special {
    CLI::Option* option;
    std::vector<std::string> fits;
  };

  std::vector<Special> special_;
  std::string run_;
  std::string what_ = "damage";
  std::string at_ = "100%peak";
  std::string look_ = "grey";
  std::string component_ = "yy";
  std::string range_ = "auto";
};

}  // namespace

CommandPointer plot_command(CLI::App& parent) { return std::make_unique<PlotCommand>(parent); }

}  // namespace app
