#include "apps/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "apps/drawing/ticks.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/version.hpp"

namespace output {
namespace {

using Runs = std::vector<ComparedRun>;

StrainUnit common_unit(const Runs& runs, const std::vector<MeasuredCurve>& measured = {}) {
  double largest = 0;
  for (const ComparedRun& run : runs)
    for (const mpm::HistoryRow& row : run.result.history) largest = std::max(largest, std::abs(row.strain));
  for (const MeasuredCurve& curve : measured)
    for (const double strain : curve.strain) largest = std::max(largest, std::abs(strain));
  return strain_unit(largest);
}

}  // namespace

Chart comparison_chart(const Runs& runs, const std::vector<MeasuredCurve>& measured) {
  const StrainUnit unit = common_unit(runs, measured);
  Chart chart{"Stress against strain of the runs", {"Strain", unit.name}, {"Stress", "MPa"}, {}, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    chart.series.push_back(stress_series(runs[i].name, ink_of_series(i), runs[i].result, unit.per_strain));
    chart.series.back().dashed = i >= series_inks;
  }
  for (std::size_t i = 0; i < measured.size(); ++i) {
    Series series{measured[i].name, {}, {}, i == 0 ? Ink::text : Ink::muted, true};
    add_line(series, measured[i].strain, measured[i].stress, unit.per_strain, 1e-6);
    chart.series.push_back(std::move(series));
  }
  return chart;
}

namespace {

/// A key figure of a run.
struct Figure {
  std::string name, unit;
  std::function<double(const mpm::Result&)> of;
  bool of_peak = false;  ///< of a run without a peak it is that of the largest stress
};

std::vector<Figure> figures(const StrainUnit& unit) {
  const double per_strain = unit.per_strain;
  const auto end = [](const mpm::Result& result) {
    return result.history.empty() ? mpm::HistoryRow{} : result.history.back();
  };
  return {
      {"Peak stress", "MPa", [](const mpm::Result& r) { return 1e-6 * r.peak_stress; }, true},
      {"Strain at the peak", unit.name, [=](const mpm::Result& r) { return per_strain * r.peak_strain; },
       true},
      {"Secant modulus at 40 %", "GPa", [](const mpm::Result& r) { return 1e-9 * secant_modulus(r); }},
      {"Strain at the end", unit.name, [=](const mpm::Result& r) { return per_strain * end(r).strain; }},
      {"Work of the platens", "J/m", [=](const mpm::Result& r) { return end(r).platen_work; }},
      {"Failures in tension", "points", [](const mpm::Result& r) { return double(r.tension_failures); }},
      {"Failures in shear", "points", [](const mpm::Result& r) { return double(r.shear_failures); }},
      {"Material points", "points", [](const mpm::Result& r) { return double(r.points); }},
      {"Steps", "steps", [](const mpm::Result& r) { return double(r.steps); }},
      {"Wall time", "s", [](const mpm::Result& r) { return r.wall_time; }},
  };
}

/// NaN for a largest stress that is no peak: how far it is from one says nothing.
double comparable(const Figure& figure, const mpm::Result& result) {
  const bool is_none = figure.of_peak && !mpm::peak_reached(result);
  return is_none ? std::numeric_limits<double>::quiet_NaN() : figure.of(result);
}

/// "3.43 (+2.1 %)": of the first run the figure alone.
std::string with_distance(double value, double first, bool is_first) {
  std::string text = rounded(value);
  if (is_first || !std::isfinite(value) || !std::isfinite(first) || first == 0) return text;
  const double distance = value / first - 1;
  return distance == 0 ? text + " (same)"
                       : text + fmt::format(" ({}{})", distance > 0 ? "+" : "", percent(distance));
}

std::vector<std::string> head(const Runs& runs, const std::string& first) {
  std::vector<std::string> cells{first};
  for (const ComparedRun& run : runs) cells.push_back(run.name);
  return cells;
}

std::string figure_table(const Runs& runs, const StrainUnit& unit) {
  std::vector<std::vector<std::string>> rows;
  for (const Figure& figure : figures(unit)) {
    std::vector<std::string> row{figure.name + " [" + figure.unit + "]"};
    const double first = comparable(figure, runs.front().result);
    for (const ComparedRun& run : runs) {
      const bool is_comparable = std::isfinite(comparable(figure, run.result));
      row.push_back(with_distance(figure.of(run.result), first, &run == &runs.front() || !is_comparable));
      if (figure.of_peak && !is_comparable) row.back() += ", no peak";
    }
    rows.push_back(std::move(row));
  }
  return number_table(head(runs, "In brackets: difference from the first run"), rows);
}

std::string setting_table(const Runs& runs, const std::vector<ComparedSetting>& settings) {
  if (settings.empty()) return paragraph("The scenes are identical.");
  std::vector<std::vector<std::string>> rows;
  for (const ComparedSetting& setting : settings) {
    rows.push_back({setting.key});
    for (const std::string& value : setting.values) rows.back().push_back(value.empty() ? "–" : value);
  }
  return number_table(head(runs, "Setting"), rows);
}

}  // namespace

std::string comparison_html(const Runs& runs, const std::vector<ComparedSetting>& settings) {
  const std::string title = "Comparison of " + std::to_string(runs.size()) + " runs";
  const StrainUnit unit = common_unit(runs);
  const Chart chart = comparison_chart(runs);
  const std::string caption = "Stress and strain are positive in the loading direction of each run.";
  const nlohmann::ordered_json data = {{"strain", {{"name", unit.name}, {"per_strain", unit.per_strain}}},
                                       {"csv", nullptr},
                                       {"charts", {{"stress", chart_json(chart)}}},
                                       {"film", nullptr}};
  return live_page(
      title,
      heading(title, std::string("mesopix ") + app::version()) +
          standing("Stress and strain",
                   [&] {
                     return section("Stress and strain", chart_figure("stress", chart, 900, 480, caption));
                   }) +
          standing("Key figures", [&] { return section("Key figures", figure_table(runs, unit)); }) +
          section("Differences between the scenes", setting_table(runs, settings)),
      inert_text(data));
}

}  // namespace output
