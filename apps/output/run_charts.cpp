#include "apps/output/run_charts.hpp"

#include <algorithm>

#include "apps/output/load_words.hpp"
#include "apps/output/run_words.hpp"
#include "apps/output/strain_unit.hpp"
#include "apps/output/text.hpp"

namespace output {
namespace {

using mpm::HistoryRow;

template <class Value>
std::vector<double> column(const std::vector<HistoryRow>& history, Value value) {
  std::vector<double> values(history.size());
  std::transform(history.begin(), history.end(), values.begin(), value);
  return values;
}

Axis strain_axis(const RunRecord& record) {
  return {capitalised(name_of_strain(record.scene)), strain_unit(record.result).name};
}

template <class Value>
Series against_strain(const RunRecord& record, const std::string& name, Ink ink, Value value,
                      bool dashed = false) {
  const auto& history = record.result.history;
  const double per_strain = strain_unit(record.result).per_strain;
  return {name, column(history, [per_strain](const HistoryRow& row) { return per_strain * row.strain; }),
          column(history, value), ink, dashed};
}

std::string peak_text(const mpm::Result& result, const StrainUnit& unit) {
  return "peak " + rounded(1e-6 * result.peak_stress) + " MPa at " +
         rounded(unit.per_strain * result.peak_strain) + " " + unit.name;
}

}  // namespace

Chart stress_chart(const RunRecord& record) {
  const mpm::Result& result = record.result;
  const StrainUnit unit = strain_unit(result);
  Chart chart{"Stress against strain in " + name_of_loading(record.scene),
              strain_axis(record),
              {capitalised(name_of_stress(record.scene)), "MPa"},
              {},
              {}};
  chart.series.push_back(
      against_strain(record, "stress", Ink::first, [](const HistoryRow& row) { return 1e-6 * row.stress; }));
  if (result.peak_stress > 0)
    chart.markers.push_back(
        {unit.per_strain * result.peak_strain, 1e-6 * result.peak_stress, peak_text(result, unit)});
  return chart;
}

Chart energy_chart(const RunRecord& record) {
  Chart chart{
      "Energies against strain", strain_axis(record), {"Energy per metre of thickness", "J/m"}, {}, {}};
  const auto add = [&](const std::string& name, Ink ink, double HistoryRow::*member) {
    chart.series.push_back(
        against_strain(record, name, ink, [member](const HistoryRow& row) { return row.*member; }));
  };
  const auto& history = record.result.history;
  const double at_start = history.empty() ? 0 : history.front().kinetic;
  chart.series.push_back(against_strain(
      record, has_platens(record.scene) ? "work put in" : "at the start", Ink::text,
      [at_start](const HistoryRow& row) { return at_start + row.platen_work; }, true));
  add("elastic", Ink::first, &HistoryRow::elastic);
  add("released", Ink::second, &HistoryRow::released);
  add("kinetic", Ink::third, &HistoryRow::kinetic);
  if (record.scene.local_damping > 0) add("damped", Ink::fourth, &HistoryRow::damped);
  if (!history.empty() && history.back().left_points > 0) add("left", Ink::fifth, &HistoryRow::left);
  return chart;
}

Chart failure_chart(const RunRecord& record) {
  Chart chart{"Failed points against strain", strain_axis(record), {"Failed points", ""}, {}, {}};
  const auto add = [&](const std::string& name, Ink ink, std::int64_t HistoryRow::*member) {
    chart.series.push_back(against_strain(
        record, name, ink, [member](const HistoryRow& row) { return static_cast<double>(row.*member); }));
  };
  add("in tension", Ink::first, &HistoryRow::tension_failures);
  add("in shear", Ink::second, &HistoryRow::shear_failures);
  return chart;
}

}  // namespace output
