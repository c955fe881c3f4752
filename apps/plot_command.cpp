#include "apps/plot_command.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "apps/codec.hpp"
#include "apps/output/chart_layout.hpp"
#include "apps/output/damage_drawing.hpp"
#include "apps/output/png.hpp"
#include "apps/output/run_charts.hpp"
#include "apps/output/strain_unit.hpp"
#include "apps/output/text.hpp"
#include "apps/output/vector_file.hpp"
#include "apps/read_option.hpp"
#include "apps/run_reader.hpp"
#include "libmpm/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double margin = 16;  ///< of paper [px]

constexpr const char* footer =
    "Examples:\n"
    "  mesopix plot runs/specimen --at 90%peak -o damage.pdf\n"
    "  mesopix plot runs/specimen --at 120e-6 --look colour -o damage.png\n"
    "  mesopix plot runs/specimen --what curve -o curve.svg";

enum class What { damage, curve };
enum class Look { grey, colour };
enum class Format { png, svg, pdf };

template <class E>
E chosen(const char* option, const std::string& text,
         std::initializer_list<std::pair<const char*, E>> words) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) {
    if (text == name) return value;
    names.emplace_back(name);
  }
  throw Rejected(Exit::usage, complaint(option, text, "must be " + listed(names)));
}

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
  const Quantity number{Dimension::ratio, {}, {}};
  if (!text.ends_with(peak)) return read_option("--at", text, number);
  const double share = read_option("--at", text.substr(0, text.size() - peak.size()), number);
  if (!(result.peak_strain > 0))
    throw Rejected(Exit::data, complaint("--at", text, "the run has no peak", "give a strain, like 120e-6"));
  return share * result.peak_strain;
}

/// Strains beyond the end of the run, or before its beginning, have no picture.
void check_reached(const std::string& text, double strain, const mpm::Result& result) {
  const double end = result.history.empty() ? 0 : result.history.back().strain;
  // A run ends where its last row is; what the reader typed for that has fewer digits.
  if (strain >= 0 && strain <= end * (1 + 1e-6)) return;
  const output::StrainUnit unit = output::strain_unit(result);
  throw Rejected(Exit::data, complaint("--at", text,
                                       "must be from 0 to " + output::rounded(unit.per_strain * end) + " " +
                                           unit.name + ", where the run ended"));
}

output::Drawing damage(const ReadRun& run, const std::string& at, Look look) {
  const double strain = strain_at(at, run.result);
  check_reached(at, strain, run.result);
  const output::StrainUnit unit = output::strain_unit(run.result);
  std::string words = output::rounded(unit.per_strain * strain) + " " + unit.name;
  if (run.result.peak_strain > 0)
    words += ", " + output::percent(strain / run.result.peak_strain, 0) + " of the peak strain";
  return output::damage_drawing(run.specimen.mask, run.result, strain,
                                look == Look::grey ? output::grey_palette() : output::colour_palette(),
                                words);
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

}  // namespace

PlotCommand::PlotCommand(CLI::App& program)
    : Command(program, "plot", "Draw the damage or the curve of a run for a paper or a slide", footer) {
  options().add_option("RUN", run_, "folder of a run")->type_name("");
  options().add_option("--what", what_, "damage or curve [damage]")->type_name("WHAT");
  options()
      .add_option("--at", at_, "strain, or share of the peak strain, of the damage [100%peak]")
      ->type_name("STRAIN");
  options().add_option("--look", look_, "grey, as in the paper, or colour [grey]")->type_name("LOOK");
  options()
      .add_option("-o,--output", output_, "the picture: .png, .svg or .pdf [WHAT.png]")
      ->type_name("FILE");
}

Exit PlotCommand::run(Console& console) {
  if (run_.empty()) throw Rejected(Exit::usage, complaint("RUN", "missing", "", "mesopix plot RUN"));
  const What what = chosen<What>("--what", what_, {{"damage", What::damage}, {"curve", What::curve}});
  const Look look = chosen<Look>("--look", look_, {{"grey", Look::grey}, {"colour", Look::colour}});
  const std::string path = output_.empty() ? what_ + ".png" : output_;
  const Format format = format_of(path);
  const ReadRun run = read_run(run_);
  const output::Drawing drawing = what == What::damage
                                      ? damage(run, at_, look)
                                      : output::lay_out(output::stress_chart(run.record()), 608, 368);
  mpm::replace_file(path, bytes_of(drawing, format));
  console.say("wrote " + path);
  return Exit::ok;
}

}  // namespace app
