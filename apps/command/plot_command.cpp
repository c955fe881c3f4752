#include "apps/command/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "apps/calibrate/calibration_target.hpp"
#include "apps/command/compared_runs.hpp"
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
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double margin = 16;        ///< of paper [px]
constexpr double per_inch = 96;      ///< px, where a px is 3/4 of a point
constexpr double inch = 0.0254;      ///< [m]
constexpr double dots = 600;         ///< per inch in print, of a PNG with a width of its own
constexpr double chart_width = 608;  ///< of a chart without a width of its own [px]
constexpr double chart_words = 13, picture_words = 14;  ///< usual size of words [px]
constexpr double least_letters = 15;                    ///< heights of letters that a figure is wide

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
    "  mesopix plot runs/a runs/b --what curve --measured test.csv --legend \"fine,coarse,test\" --width "
    "\"90 mm\" -o "
    "curves.pdf\n"
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

/// What a figure is in print.
struct Paper {
  double width = 0;  ///< [px]; 0 = that of the drawing
  double text = 0;   ///< size of the words [px]; 0 = the usual one

  /// Of a drawing of a width [px] and its margins: px in print per px of the drawing.
  [[nodiscard]] double scale(double drawn) const { return width > 0 ? width / (drawn + 2 * margin) : 1; }

  /// Size of words over the usual one on a drawing that is printed at a scale.
  [[nodiscard]] double words(double usual, double scale) const {
    return text > 0 ? text / (scale * usual) : 1;
  }
};

double font_size(const std::string& text) {
  std::string_view number = trimmed(text);
  if (number.ends_with("pt")) number = trimmed(number.substr(0, number.size() - 2));
  return read_option("font-size", std::string(number), QuantityCodec{Dimension::ratio, between(4, 40)});
}

Paper read_paper(const std::string& width, const std::string& font) {
  Paper paper;
  if (!width.empty())
    paper.width =
        read_option("width", width, QuantityCodec{Dimension::length, between(0.02, 2)}) / inch * per_inch;
  if (!width.empty() || !font.empty()) paper.text = (font.empty() ? 8 : font_size(font)) / 0.75;
  const double most = (paper.width > 0 ? paper.width : 2 * margin + output::picture_width) / least_letters;
  if (paper.text > most)
    throw Rejected(
        Exit::usage, font.empty() ? "--width" : "--font-size", font.empty() ? width : font,
        fmt::format("words of {:.3g} pt do not fit; they must have {:.2g} pt at most in this width",
                    0.75 * paper.text, std::floor(7.5 * most) / 10));
  return paper;
}

/// A strain, or a share of that at the peak: "120e-6", "0.5 %", "90%peak". By default that of the largest
/// stress, be it a peak or not.
double strain_at(const std::string& text, const mpm::Result& result) {
  if (text.empty()) return result.peak_strain;
  constexpr std::string_view peak = "peak";
  const QuantityCodec number{Dimension::ratio};
  if (!text.ends_with(peak)) return read_option("at", text, number);
  const double share = read_option("at", text.substr(0, text.size() - peak.size()), number);
  if (!mpm::peak_reached(result))
    throw Rejected(Exit::data, "--at", text,
                   "the run reached no peak: its stress had not fallen again when it ended, at strain " +
                       strain_text(output::largest_strain(result)),
                   "give a strain, like 120e-6");
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

output::Drawing damage(const ReadRun& run, double strain, Palette look, double text) {
  return output::damage_drawing(run.specimen.mask, run.result, strain,
                                look == Palette::grey ? output::grey_palette() : output::colour_palette(),
                                output::strain_words(run.result, strain, 0), text);
}

std::string bytes_of(const output::Drawing& drawing, Format format, const Paper& paper) {
  const double scale = paper.scale(drawing.width);
  if (format == Format::png)
    return paper.width > 0 ? output::png_of(drawing, scale * dots / per_inch, margin, dots)
                           : output::png_of(drawing, 2.5, margin);
  return output::vector_file(drawing,
                             format == Format::svg ? output::VectorFormat::svg : output::VectorFormat::pdf,
                             margin, 0.75 * scale);
}

/// What curves are shown, and under which names.
struct Curves {
  std::vector<std::string> runs;      ///< folders
  std::vector<std::string> measured;  ///< tables
  std::string legend;                 ///< names for both, "none", or empty: those of folders and files
};

/// Names between commas, one a curve.   @throws Rejected (Exit::usage) for more or fewer.
void rename(std::vector<output::ComparedRun>& runs, std::vector<output::MeasuredCurve>& measured,
            const std::string& legend) {
  const std::vector<std::string> names = items_between(legend, ',');
  if (names.size() != runs.size() + measured.size())
    throw Rejected(Exit::usage, "--legend", legend,
                   fmt::format("has {} for {}", counted(static_cast<std::int64_t>(names.size()), "name"),
                               counted(static_cast<std::int64_t>(runs.size() + measured.size()), "curve")),
                   "give one for each, runs first, with commas between them, or none");
  std::size_t next = 0;
  for (output::ComparedRun& run : runs) run.name = names[next++];
  for (output::MeasuredCurve& curve : measured) curve.name = names[next++];
}

output::Chart chart_of(const Curves& curves) {
  if (curves.runs.size() == 1 && curves.measured.empty()) {
    if (!curves.legend.empty())
      throw Rejected(Exit::usage, "--legend", curves.legend, "changes nothing of a single curve");
    return output::stress_chart(read_run(curves.runs.front()).record());
  }
  std::vector<output::ComparedRun> runs = read_compared(curves.runs);
  std::vector<output::MeasuredCurve> measured;
  for (const std::string& path : curves.measured) {
    Curve curve = read_target_curve(path);
    measured.push_back({fs::path(path).stem().string(), std::move(curve.strain), std::move(curve.stress)});
  }
  const bool none = curves.legend == "none";
  if (!none && !curves.legend.empty()) rename(runs, measured, curves.legend);
  output::Chart chart = output::comparison_chart(runs, measured);
  chart.has_legend = !none;
  return chart;
}

/// In the size in which it is printed.
output::Drawing curve_drawing(const Curves& curves, const Paper& paper) {
  const double width = paper.width > 0 ? paper.width - 2 * margin : chart_width;
  return output::lay_out(chart_of(curves), width, width * 368 / chart_width, paper.words(chart_words, 1));
}

class PlotCommand : public Command {
 public:
  explicit PlotCommand(CLI::App& program)
      : Command(program, "plot", "Draw damage, stress or the curve of a run for a paper or a slide",
                plot_footer) {
    option("RUN", curves_.runs, "folder of a run; of curves, of up to 10 runs", folder_form());
    option("--what", what_, "what to draw [damage]", one_of({"damage", "stress", "curve"}));
    add("--at", at_, text_form("STRAIN"),
        "strain, or share of the peak strain, of damage or stress; of a run without a peak its largest "
        "stress "
        "[100%peak]",
        {"damage", "stress"});
    add("--look", look_, one_of({"grey", "colour"}), "of damage; grey is as in the paper [grey]", {"damage"});
    add("--component", component_, one_of({"yy", "xx", "xy", "first", "third", "mises"}), "of stress [yy]",
        {"stress"});
    add("--range", range_, text_form("LOW:HIGH", {"auto"}),
        "of the colours of stress, as \"-5:5 MPa\" [auto]", {"stress"});
    special_.push_back(
        {option("--measured", curves_.measured,
                "curve of a test to lay over those of runs, a table as for mesopix calibrate; may "
                "be given again",
                file_form({"csv"}, "CURVE.csv")),
         {"curve"}});
    add("--legend", curves_.legend, text_form("NAME,...", {"none"}),
        "of several curves, in their order [folders and files]", {"curve"});
    option("--width", width_, "of the figure in print, margins included [170 mm]",
           QuantityCodec{Dimension::length}.form());
    option("--font-size", font_, "of the words in print, in points [8 with --width, else 10]",
           text_form("POINTS"));
    option("-o,--output", output_, "the picture: .png, .svg or .pdf [WHAT.png]",
           file_form({"png", "svg", "pdf"}));
    json_and_quiet("the file and what it shows as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(curves_.runs.empty() ? "" : curves_.runs.front(), "RUN", "mesopix plot RUN");
    const What what = chosen<What>(
        "--what", what_, {{"damage", What::damage}, {"stress", What::stress}, {"curve", What::curve}});
    check_fit();
    if (what != What::curve && curves_.runs.size() > 1)
      throw Rejected(Exit::usage, "RUN", std::to_string(curves_.runs.size()) + " given",
                     "must be one for --what " + what_ + "; curves may be of several");
    const Palette look =
        chosen<Palette>("--look", look_, {{"grey", Palette::grey}, {"colour", Palette::colour}});
    const StressComponent component = chosen<StressComponent>("--component", component_, components);
    std::optional<output::ColourScale> range;
    if (range_ != "auto") range = read_range(range_);
    const Paper paper = read_paper(width_, font_);
    const double text = paper.words(picture_words, paper.scale(output::picture_width));
    const std::string path = output_.empty() ? what_ + ".png" : output_;
    const Format format = format_of(path);
    std::string words = "wrote " + path;
    nlohmann::ordered_json shown{{"files", {path}}, {"what", what_}};
    output::Drawing drawing;
    if (what == What::curve) {
      drawing = curve_drawing(curves_, paper);
    } else {
      const ReadRun run = read_run(curves_.runs.front());
      const double strain = reached_strain(at_, run.result);
      if (what == What::damage) {
        shown["strain"] = strain;
        drawing = damage(run, strain, look, text);
      } else {
        StressPlot plot = stress_plot(run, curves_.runs.front(), strain, component, range, text);
        drawing = std::move(plot.drawing);
        words += ": " + plot.words;
        shown["frame"] = plot.words;
      }
    }
    mpm::replace_file(path, bytes_of(drawing, format, paper));
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
  Curves curves_;
  std::string width_, font_;
  std::string what_ = "damage";
  std::string at_;
  std::string look_ = "grey";
  std::string component_ = "yy";
  std::string range_ = "auto";
};

}  // namespace

CommandPointer plot_command(CLI::App& parent) { return std::make_unique<PlotCommand>(parent); }

}  // namespace app
