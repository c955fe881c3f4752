// The report of a run, and its section on the error of the peak.
#include "apps/report/report.hpp"

#include <fmt/format.h>

#include "apps/drawing/ticks.hpp"
#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"
#include "apps/text/figures.hpp"

namespace output {

std::string report_html(const RunRecord& record) {
  const struct {
    const char* heading;
    std::string (*of)(const RunRecord&);
  } sections[] = {{"Stress and strain", curve_section},
                  {"Error of the peak", error_section},
                  {"Film of the damage", film_section},
                  {"Damage", damage_section},
                  {"Specimen", specimen_section},
                  {"Energies and failures", ledger_section},
                  {"Solution and provenance", solution_section},
                  {"Notes", notes_section},
                  {"Scene", scene_section},
                  {"Glossary", [](const RunRecord&) { return glossary_section(); }},
                  {"How to cite", citation_section}};
  std::string html = header_html(record);
  for (const auto& one : sections) html += standing(one.heading, [&] { return one.of(record); });
  return live_page(title_of(record), html, report_data(record));
}

namespace {

std::string error_text(double error) { return rounded(100 * error, 2) + " %"; }

std::vector<std::string> row_of(const ErrorSource& source, const StrainUnit& unit) {
  const std::string above = source.peak_reached ? "" : "> ";  // it ended before its peak
  return {source.name,
          source.compared + (source.peak_reached ? "" : ", no peak"),
          above + rounded(1e-6 * source.peak_stress, 4),
          above + rounded(unit.per_strain * source.peak_strain, 4),
          above + error_text(source.stress_error),
          above + error_text(source.strain_error),
          rounded(source.wall_time, 2)};
}

}  // namespace

std::string error_section(const RunRecord& record) {
  const ErrorEstimate& estimate = record.error_estimate;
  if (estimate.sources.empty()) return {};
  const StrainUnit unit = strain_unit(record.result);
  std::vector<std::vector<std::string>> rows;
  for (const ErrorSource& source : estimate.sources) rows.push_back(row_of(source, unit));
  return section(
      "Error of the peak",
      paragraph(fmt::format(
          "At {} {} in stress and {} in strain, if all errors have the same sign{}; estimated from {} "
          "in {} s.",
          estimate.is_least() ? "least" : "most", error_text(estimate.stress_error()),
          error_text(estimate.strain_error()),
          estimate.is_least() ? ", and more where a run that was compared with ended before its peak" : "",
          estimate.sources.size() == 1 ? "a second run" : "further runs", rounded(estimate.wall_time(), 2))) +
          number_table({"Source", "Compared with", "Peak stress [MPa]", "Peak strain [" + unit.name + "]",
                        "Error of stress", "Error of strain", "Wall time [s]"},
                       rows) +
          remarks(paragraph(
              "The estimate covers the numerics only, not the material law, its parameters or the picture. "
              "With brittle phases a different order of failures alone changes the peak by some tenths of a "
              "per cent, and a coarser picture has another random strength field.")));
}

}  // namespace output
