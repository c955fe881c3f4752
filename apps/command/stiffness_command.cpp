#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/command/command.hpp"
#include "apps/job/job.hpp"
#include "apps/job/stiffness.hpp"
#include "apps/scene/input.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/text/markup.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* stiffness_footer =
    "The stiffness under uniform stress, periodic edges and uniform strain, in this order, never falls;\n"
    "the nearer they are, the better does the specimen stand for the material. Several specimens give a row\n"
    "each, with their mean and scatter. The settings of the specimen are options too, as of simulate.\n"
    "Examples: a specimen; of a photograph, in plane stress; how much three specimens scatter\n"
    "  mesopix stiffness specimen.h5\n"
    "  mesopix stiffness photo.jpg --convert.width \"150 mm\" --plane stress --mortar.young \"25 GPa\"\n"
    "  mesopix stiffness one.h5 two.h5 three.h5 -o stiffness.json";

/// A figure of every specimen.
struct StiffnessColumn {
  const char* key;
  const char* title;
  int decimals;
  double scale;  ///< of the table
  double (*of)(const BoundaryStiffness&);
};
constexpr StiffnessColumn stiffness_columns[] = {
    {"young_Pa", "E (GPa)", 3, 1e-9, [](const BoundaryStiffness& one) { return one.moduli.constants.young; }},
    {"poisson", "nu", 4, 1, [](const BoundaryStiffness& one) { return one.moduli.constants.poisson; }},
    {"anisotropy", "anisotropy (%)", 2, 100,
     [](const BoundaryStiffness& one) { return one.moduli.anisotropy; }}};

using Reports = std::vector<StiffnessReport>;

MeanEstimate estimate_of(const Reports& reports, std::size_t boundary, const StiffnessColumn& column) {
  std::vector<double> values;
  for (const StiffnessReport& report : reports) values.push_back(column.of(report.boundaries.at(boundary)));
  return mean_estimate(values);
}

std::string table_of(const Reports& reports, const StiffnessColumn& column) {
  std::size_t width = 24;
  for (const StiffnessReport& report : reports) width = std::max(width, report.name.size() + 2);
  std::string text = fmt::format("{:<{}}{:>16}{:>16}{:>16}\n", column.title, width, "uniform stress",
                                 "periodic", "uniform strain");
  const auto row = [&](const std::string& name, const auto& figure) {
    text += fmt::format("{:<{}}", "  " + name, width);
    for (std::size_t i = 0; i < all_boundaries.size(); ++i)
      text += fmt::format("{:>16.{}f}", column.scale * figure(i), column.decimals);
    text += '\n';
  };
  for (const StiffnessReport& report : reports)
    row(report.name, [&](std::size_t i) { return column.of(report.boundaries.at(i)); });
  row("mean", [&](std::size_t i) { return estimate_of(reports, i, column).mean; });
  row("standard deviation", [&](std::size_t i) { return estimate_of(reports, i, column).deviation; });
  return text;
}

std::string tables_of(const Reports& reports) {
  if (reports.size() == 1) return stiffness_text(reports.front());
  std::string text;
  for (const StiffnessColumn& column : stiffness_columns) text += table_of(reports, column);
  return text;
}

Json spread_json(const Reports& reports) {
  Json spread = Json::object();
  for (std::size_t i = 0; i < all_boundaries.size(); ++i)
    for (const StiffnessColumn& column : stiffness_columns) {
      const MeanEstimate estimate = estimate_of(reports, i, column);
      spread[boundary_word(all_boundaries.at(i))][column.key] = {{"mean", estimate.mean},
                                                                 {"standard_deviation", estimate.deviation},
                                                                 {"half_width_95", estimate.half_width}};
    }
  return spread;
}

Json reports_json(const Reports& reports) {
  Json json{{"specimens", Json::array()}};
  for (const StiffnessReport& report : reports) json["specimens"].push_back(stiffness_json(report));
  if (reports.size() > 1) json["spread"] = spread_json(reports);
  return json;
}

class StiffnessCommand : public SettingsCommand {
 public:
  explicit StiffnessCommand(CLI::App& program)
      : SettingsCommand(program, "stiffness", "Tell the effective elastic moduli of specimens",
                        stiffness_footer, offer_of_stiffness()) {
    option("INPUT", inputs_, "specimens, scenes or pictures", file_form(picture_endings({"h5", "toml"})));
    option("-o,--output", output_, "file for the figures, as JSON", file_form({"json"}));
    json_and_quiet("the figures as JSON on standard output");
  }

  Exit run(Console& console) override {
    require(inputs_.empty() ? std::string() : inputs_.front(), "INPUT", "mesopix stiffness INPUT");
    check_output();
    refuse_strengths(settings_.assignments());
    Reports reports;
    for (const std::string& input : inputs_) {
      reports.push_back(report_of(input, console));
      for (const std::string& doubt : reports.back().doubts) console.warn(doubt);
      for (const std::string& note : stiffness_notes(reports.back())) console.say("note: " + note);
    }
    if (!output_.empty()) mpm::replace_file(output_, json_text(reports_json(reports)));
    if (json_)
      console.out << json_text(reports_json(reports));
    else if (!quiet_)
      console.out << printable_lines(tables_of(reports));
    if (!output_.empty()) console.say("wrote " + output_);
    return Exit::ok;
  }

 private:
  void check_output() const {
    if (output_.empty()) return;
    if (std::filesystem::path(output_).extension() != ".json")
      throw Rejected(Exit::usage, "-o", output_, "must end in .json");
  }

  [[nodiscard]] StiffnessReport report_of(const std::string& input, Console& console) const {
    Resolved resolved = resolve_input("INPUT", input, settings_.assignments());
    console.locate = located_by(resolved.origins);
    settle_source(resolved.settings);
    const Prepared cells = prepare_cells(resolved.settings);
    for (const std::string& note : cells.notes) console.say("note: " + note);
    return measure_stiffness(input, cells.specimen, resolved.settings);
  }

  std::vector<std::string> inputs_;
};

}  // namespace

CommandPointer stiffness_command(CLI::App& parent) { return std::make_unique<StiffnessCommand>(parent); }

}  // namespace app
