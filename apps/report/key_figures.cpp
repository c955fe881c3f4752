#include "apps/report/key_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/drawing/damage_picture.hpp"
#include "apps/text/figures.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/describe/statistics.hpp"

namespace output {
namespace {

std::string cell(double value) { return exact(value); }
std::string cell(std::int64_t value) { return std::to_string(value); }

std::string header_of(const mpm::HistoryColumn& column) { return column_title(column.name, column.unit); }

/// One line of the table; text_of gives the cell of a column.
template <class TextOf>
std::string line(TextOf text_of) {
  std::string text;
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    if (!text.empty()) text += ',';
    text += text_of(column);
  }
  return text + '\n';
}

}  // namespace

std::string column_title(std::string_view name, std::string_view unit) {
  std::string title(name);
  if (unit == "1") return title;
  title += '_';
  for (const char c : unit) title += c == '/' ? std::string("_per_") : std::string(1, c);
  return title;
}

std::string curve_csv(const std::vector<mpm::HistoryRow>& history) {
  std::string csv = line(header_of);
  for (const mpm::HistoryRow& row : history)
    csv += line([&](const mpm::HistoryColumn& column) {
      return std::visit([&](auto member) { return cell(row.*member); }, column.member);
    });
  return csv;
}

double leading_force(const mpm::Scene& scene, double stress) {
  return stress * scene.width() * scene.fixture.thickness;
}

double leading_displacement(const mpm::Scene& scene, double strain) { return strain * scene.height(); }

std::string curve_csv(const RunRecord& record) {
  const std::string plain = curve_csv(record.result.history);
  const bool has_loads = record.scene.fixture.has_loads();
  const auto& gauges = record.result.gauges;
  if (!has_loads && gauges.empty()) return plain;
  std::istringstream lines(plain);
  std::string csv, line;
  std::getline(lines, line);
  csv = line + (has_loads ? ",displacement_m,force_N" : "");
  for (const mpm::GaugeReadings& gauge : gauges) csv += "," + column_title(gauge.name, "m");
  csv += '\n';
  for (std::size_t i = 0; std::getline(lines, line); ++i) {
    csv += line;
    const mpm::HistoryRow& row = record.result.history[i];
    if (has_loads)
      csv += "," + cell(leading_displacement(record.scene, row.strain)) + "," +
             cell(leading_force(record.scene, row.stress));
    for (const mpm::GaugeReadings& gauge : gauges) csv += "," + cell(gauge.values[i]);
    csv += '\n';
  }
  return csv;
}

namespace {

void count_pixel(FailureCount& count, const mpm::Result& result, Eigen::Index pixel) {
  ++count.points;
  if (result.failure_mode.size() == 0) return;
  const auto mode = static_cast<mpm::FailureMode>(result.failure_mode.data()[pixel]);
  count.tension += mode == mpm::FailureMode::tension;
  count.shear += mode == mpm::FailureMode::shear;
  count.crushed += result.crush_strain.size() > 0 && !std::isnan(result.crush_strain.data()[pixel]);
}

}  // namespace

std::vector<FailureCount> failures_by_phase(const RunRecord& record) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  std::vector<FailureCount> counts;
  for (const std::string& phase : mask.phases) counts.push_back({phase});
  for (std::size_t i = 0; i < mask.labels.size(); ++i)
    count_pixel(counts.at(mask.labels.data[i]), record.result, static_cast<Eigen::Index>(i));
  std::erase_if(counts, [](const FailureCount& count) { return count.points == 0; });
  return counts;
}

FailureCount failures_of_extra_points(const RunRecord& record, const std::vector<FailureCount>& by_phase) {
  FailureCount extra{"extra points", static_cast<std::int64_t>(record.scene.extra_points.size()),
                     record.result.tension_failures, record.result.shear_failures, 0};
  for (const FailureCount& count : by_phase) {
    extra.tension -= count.tension;
    extra.shear -= count.shear + count.crushed;
  }
  return extra;
}

const mpm::HistoryRow& peak_row(const mpm::Result& result) {
  const auto& rows = result.history;
  const auto at_peak = std::find_if(rows.begin(), rows.end(), [&](const mpm::HistoryRow& row) {
    return result.peak_stress > 0 && row.strain == result.peak_strain;
  });
  if (at_peak != rows.end()) return *at_peak;
  return *std::max_element(rows.begin(), rows.end(), [](const mpm::HistoryRow& a, const mpm::HistoryRow& b) {
    return a.stress < b.stress;
  });
}

InertiaShares inertia_of(const mpm::HistoryRow& row) {
  const auto of_work = [&](double energy) { return row.platen_work > 0 ? energy / row.platen_work : 0; };
  return {mpm::platen_imbalance(row), of_work(row.kinetic), of_work(row.damped)};
}

nlohmann::json peak_figures(const mpm::Result& result) {
  const bool peak = mpm::peak_reached(result);
  const auto of_peak = [&](double value) { return peak ? nlohmann::json(value) : nlohmann::json(nullptr); };
  return {{"peak_reached", peak},
          {"peak_stress_Pa", of_peak(result.peak_stress)},
          {"peak_strain", of_peak(result.peak_strain)},
          {"largest_stress_Pa", result.peak_stress},
          {"strain_at_largest_stress", result.peak_strain}};
}

double secant_modulus(const mpm::Result& result) {
  const auto reached = [&](const mpm::HistoryRow& row) {
    return row.strain > 0 && row.stress > 0 && row.stress >= 0.4 * result.peak_stress;
  };
  const auto row = std::find_if(result.history.begin(), result.history.end(), reached);
  return row == result.history.end() ? std::numeric_limits<double>::quiet_NaN() : row->stress / row->strain;
}

std::vector<std::pair<std::string, double>> phase_shares(const specimen::LabelledMask& mask) {
  const std::vector<double> fractions = specimen::fractions(mask);
  std::vector<std::pair<std::string, double>> shares;
  for (std::size_t label = 0; label < fractions.size(); ++label)
    if (fractions[label] > 0) shares.emplace_back(mask.phases[label], fractions[label]);
  return shares;
}

std::vector<std::string> all_notes(const RunRecord& record) {
  std::vector<std::string> notes = record.notes;
  const std::string missing = missing_note(damage_stages(record.result));
  if (!missing.empty()) notes.push_back(missing);
  return notes;
}

}  // namespace output
