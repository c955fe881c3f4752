#include "apps/output/run_charts.hpp"

#include <algorithm>

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

Axis strain_axis() { return {"Platen strain", "microstrain"}; }

template <class Value>
Series against_strain(const RunRecord& record, const std::string& name, Ink ink, Value value,
                      bool dashed = false) {
  const auto& history = record.result.history;
  return {name, column(history, [](const HistoryRow& row) { return 1e6 * row.strain; }),
          column(history, value), ink, dashed};
}

std::string loading_word(const RunRecord& record) {
  return record.scene.loading.direction == mpm::Direction::tension ? "tension" : "compression";
}

}  // namespace

Chart stress_chart(const RunRecord& record) {
  const mpm::Result& result = record.result;
  Chart chart{"Stress against strain in " + loading_word(record), strain_axis(), {"Stress", "MPa"}, {}, {}};
  chart.series.push_back(
      against_strain(record, "stress", Ink::first, [](const HistoryRow& row) { return 1e-6 * row.stress; }));
  if (result.peak_stress > 0)
    chart.markers.push_back({1e6 * result.peak_strain, 1e-6 * result.peak_stress,
                             "peak " + rounded(1e-6 * result.peak_stress) + " MPa at " +
                                 rounded(1e6 * result.peak_strain) + " microstrain"});
  return chart;
}

Chart energy_chart(const RunRecord& record) {
  Chart chart{"Energies against strain", strain_axis(), {"Energy per metre of thickness", "J/m"}, {}, {}};
  const auto add = [&](const std::string& name, Ink ink, double HistoryRow::*member, bool dashed = false) {
    chart.series.push_back(against_strain(
        record, name, ink, [member](const HistoryRow& row) { return row.*member; }, dashed));
  };
  add("work put in", Ink::text, &HistoryRow::platen_work, true);
  add("elastic", Ink::first, &HistoryRow::elastic);
  add("released", Ink::second, &HistoryRow::released);
  add("kinetic", Ink::third, &HistoryRow::kinetic);
  if (record.scene.local_damping > 0) add("damped", Ink::fourth, &HistoryRow::damped);
  return chart;
}

Chart failure_chart(const RunRecord& record) {
  Chart chart{"Failed points against strain", strain_axis(), {"Failed points", ""}, {}, {}};
  const auto add = [&](const std::string& name, Ink ink, std::int64_t HistoryRow::*member) {
    chart.series.push_back(against_strain(
        record, name, ink, [member](const HistoryRow& row) { return static_cast<double>(row.*member); }));
  };
  add("in tension", Ink::first, &HistoryRow::tension_failures);
  add("in shear", Ink::second, &HistoryRow::shear_failures);
  return chart;
}

}  // namespace output
