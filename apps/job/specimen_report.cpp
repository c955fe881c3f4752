#include "apps/job/specimen_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/text/words.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/describe/statistics.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

const char* mode_name(specimen::ItzMode mode) {
  switch (mode) {
    case specimen::ItzMode::ring:
      return "ring";
    case specimen::ItzMode::points:
      return "points";
    case specimen::ItzMode::none:
      return "none";
  }
  return "";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json phases_json(const specimen::LabelledMask& mask) {
  const auto pixels = specimen::count_labels(mask);
  const auto shares = specimen::fractions(mask);
  Json phases = Json::object();
  for (std::size_t label = 0; label < mask.phases.size(); ++label)
    phases[mask.phases[label]] = {{"label", label}, {"pixels", pixels[label]}, {"fraction", shares[label]}};
  return phases;
}

Json sieve_json(const specimen::Specimen& specimen, const specimen::Grading& target) {
  Json rows = Json::array();
  if (specimen.inclusions.empty()) return rows;
  for (const specimen::Passing& point : specimen::sieve_curve(specimen.inclusions, target))
    rows.push_back(
        {{"diameter_m", point.diameter}, {"passing", point.reached}, {"target", number(point.target)}});
  return rows;
}

Json aggregates_json(const specimen::Specimen& specimen, const specimen::Grading& target) {
  double area = 0;
  std::vector<double> diameters;
  for (const specimen::Inclusion& inclusion : specimen.inclusions) {
    area += inclusion.area;
    diameters.push_back(inclusion.equivalent_diameter);
  }
  const auto [smallest, largest] = std::minmax_element(diameters.begin(), diameters.end());
  return {{"count", specimen.inclusions.size()},
          {"area_fraction", area / (specimen.mask.width() * specimen.mask.height())},
          {"smallest_m", diameters.empty() ? Json(nullptr) : Json(*smallest)},
          {"largest_m", diameters.empty() ? Json(nullptr) : Json(*largest)},
          {"sieve", sieve_json(specimen, target)}};
}

std::string millimetres(const Json& metres) { return fmt::format("{:.4g} mm", 1e3 * metres.get<double>()); }

std::string percent(const Json& share) { return fmt::format("{:.1f} %", 100 * share.get<double>()); }

std::string phases_text(const Json& phases) {
  std::string text;
  for (const auto& [name, phase] : phases.items())
    if (phase["pixels"] > 0)
      text += fmt::format("  {:<12} {:>7}   {} pixels\n", name, percent(phase["fraction"]),
                          phase["pixels"].get<std::int64_t>());
  return text;
}

std::string sieve_text(const Json& rows) {
  if (rows.empty()) return {};
  const bool has_target = !rows.front()["target"].is_null();
  std::string text = has_target ? "  sieve        passing   target\n" : "  sieve        passing\n";
  for (const Json& row : rows)
    text += fmt::format("  {:<12} {:>7}{}\n", millimetres(row["diameter_m"]), percent(row["passing"]),
                        has_target ? fmt::format(" {:>8}", percent(row["target"])) : "");
  return text;
}

std::string aggregates_text(const Json& aggregates) {
  if (aggregates["count"] == 0) return "no aggregates\n";
  const std::string smallest = millimetres(aggregates["smallest_m"]);
  const std::string largest = millimetres(aggregates["largest_m"]);
  return fmt::format("{} of {}, {} of the area\n",
                     counted(aggregates["count"].get<std::int64_t>(), "aggregate"),
                     smallest == largest ? largest : smallest + " to " + largest,
                     percent(aggregates["area_fraction"])) +
         sieve_text(aggregates["sieve"]);
}

std::string source_text(const Json& source) {
  const auto from = source["from"].get<std::string>();
  if (from != "generated") return "from " + from;
  return fmt::format("generated with seed {}", source["seed"].get<std::uint64_t>());
}

}  // namespace

Json specimen_json(const specimen::Specimen& specimen, const specimen::Grading& target) {
  const specimen::LabelledMask& mask = specimen.mask;
  return {{"kind", "specimen"},
          {"width_m", mask.width()},
          {"height_m", mask.height()},
          {"pixel_size_m", mask.pixel_size},
          {"columns", mask.labels.cols},
          {"rows", mask.labels.rows},
          {"phases", phases_json(mask)},
          {"aggregates", aggregates_json(specimen, target)},
          {"itz",
           {{"mode", mode_name(specimen.itz.mode)},
            {"thickness_m", specimen.itz.thickness > 0 ? specimen.itz.thickness : mask.pixel_size},
            {"rings", specimen.rings.size()}}},
          {"warnings", specimen::doubts_of(specimen)},
          {"source",
           {{"from", specimen.provenance.source},
            {"sha256", specimen.provenance.sha256},
            {"seed", specimen.provenance.seed},
            {"version", specimen.provenance.version}}}};
}

std::string specimen_heading(const Json& figures) {
  return fmt::format("specimen {} x {}, {} x {} pixels of {}, {}", millimetres(figures["width_m"]),
                     millimetres(figures["height_m"]), figures["columns"].get<int>(),
                     figures["rows"].get<int>(), millimetres(figures["pixel_size_m"]),
                     source_text(figures["source"]));
}

std::string specimen_text(const Json& figures) {
  return specimen_heading(figures) + "\n" + phases_text(figures["phases"]) +
         aggregates_text(figures["aggregates"]);
}

}  // namespace app
