#include "apps/calibrate/calibration_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/calibrate/bounded_minimum.hpp"
#include "apps/calibrate/calibration_words.hpp"
#include "apps/text/html.hpp"
#include "apps/report/load_words.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/drawing/strain_unit.hpp"
#include "apps/text/text.hpp"
#include "apps/calibrate/parameter_spread.hpp"

namespace app {
namespace {

using output::Chart;
using output::Ink;
using output::Series;
using output::StrainUnit;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Beyond, a broken specimen only trembles, and hides what was fitted.
double last_strain_shown(const Target& target, const Calibration& calibration) {
  double farthest = 0;
  for (const auto* runs : {&calibration.runs, &calibration.further_runs})
    for (const SeedRun& run : *runs) farthest = std::max(farthest, 2 * run.peak_strain);
  return target.curve.empty() ? farthest : 1.1 * target.curve.last_strain();
}

StrainUnit unit_of(const Calibration& calibration) {
  double largest = 0;
  for (const SeedRun& run : calibration.runs) largest = std::max(largest, run.strain.back());
  return output::strain_unit(largest);
}

void add_curve(Series& series, const std::vector<double>& strain, const std::vector<double>& stress,
               const StrainUnit& unit, double last_strain) {
  for (std::size_t i = 0; i < strain.size() && strain[i] <= last_strain; ++i) {
    series.x.push_back(unit.per_strain * strain[i]);
    series.y.push_back(1e-6 * stress[i]);
  }
  series.x.push_back(gap);
  series.y.push_back(gap);
}

/// The curves of several runs as one line with gaps.
Series runs_series(const std::string& name, Ink ink, const std::vector<SeedRun>& runs, const StrainUnit& unit,
                   double last_strain) {
  Series series{fmt::format("{}, {} seed{}", name, runs.size(), runs.size() == 1 ? "" : "s"), {}, {}, ink};
  for (const SeedRun& run : runs) add_curve(series, run.strain, run.stress, unit, last_strain);
  return series;
}

Series target_curve_series(const TargetCurve& curve, const StrainUnit& unit) {
  Series series{"target", {}, {}, Ink::text, true};
  add_curve(series, curve.strain, curve.stress, unit, curve.last_strain());
  return series;
}

/// A dashed line up or along to what is wanted of the peak, and a dot where that is a point.
void add_target_peak(Chart& chart, const Target& target, const Calibration& calibration,
                     const StrainUnit& unit) {
  const Peak found = mean_peak(calibration.runs);
  const double strain = unit.per_strain * target.peak_strain.value_or(found.strain);
  const double stress = 1e-6 * target.peak_stress.value_or(found.stress);
  Series series{"target", {}, {}, Ink::text, true};
  if (target.peak_stress) {
    series.x = {0, strain};
    series.y = {stress, stress};
  }
  if (target.peak_strain) {
    series.x.insert(series.x.end(), {strain, strain});
    series.y.insert(series.y.end(), {stress, 0});
  }
  chart.series.push_back(std::move(series));
  if (target.peak_stress && target.peak_strain)
    chart.markers.push_back(
        {strain, stress,
         fmt::format("target {} MPa at {} {}", output::rounded(stress), output::rounded(strain), unit.name)});
}

Chart curves_chart(const CalibrationTask& task, const Calibration& calibration) {
  const StrainUnit unit = unit_of(calibration);
  const double last = last_strain_shown(task.target, calibration);
  Chart chart{"Target and fitted curves", {"Platen strain", unit.name}, {"Stress", "MPa"}, {}, {}};
  if (!calibration.further_runs.empty())
    chart.series.push_back(runs_series("checked", Ink::muted, calibration.further_runs, unit, last));
  chart.series.push_back(runs_series("fitted", Ink::first, calibration.runs, unit, last));
  if (task.target.curve.empty())
    add_target_peak(chart, task.target, calibration, unit);
  else
    chart.series.push_back(target_curve_series(task.target.curve, unit));
  return chart;
}

/// Misfit over the evaluations; the search of a fit to a curve begins with its peak.
Chart search_chart(const Calibration& calibration) {
  Chart chart{"Misfit of the evaluations", {"Evaluation", ""}, {"Misfit", "%"}, {}, {}};
  Series coarse{"of the peak", {}, {}, Ink::third};
  Series fine{"of the target", {}, {}, Ink::first};
  for (std::size_t i = 0; i < calibration.history.size(); ++i) {
    const Evaluation& evaluation = calibration.history[i];
    Series& series = evaluation.coarse ? coarse : fine;
    series.x.push_back(static_cast<double>(i + 1));
    series.y.push_back(100 * evaluation.misfit);
  }
  for (Series* series : {&coarse, &fine})
    if (!series->x.empty()) chart.series.push_back(std::move(*series));
  return chart;
}

std::string parameters_table(const CalibrationTask& task, const Calibration& calibration) {
  const auto spread = parameter_spread(task, calibration);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < task.parameters.size(); ++i) {
    const FreeParameter& parameter = task.parameters[i];
    const double factor = calibration.best_evaluation().factors[i];
    for (const ScaledSetting& setting : parameter.settings)
      rows.push_back({setting.field.key, setting.text(1), setting.text(factor), output::rounded(factor, 4),
                      spread ? output::percent((*spread)[i]) : "\u2013",
                      setting.text(parameter.low) + " to " + setting.text(parameter.high)});
  }
  return output::number_table({"Setting", "In the scene", "Fitted", "Factor", "Standard deviation", "Bounds"},
                              rows);
}

std::vector<std::string> peak_row(const std::string& name, double stress, double strain,
                                  const StrainUnit& unit) {
  return {name, output::rounded(1e-6 * stress), output::rounded(unit.per_strain * strain)};
}

void add_peaks(std::vector<std::vector<std::string>>& rows, const std::string& name,
               const std::vector<SeedRun>& runs, const StrainUnit& unit) {
  for (const SeedRun& run : runs)
    rows.push_back(
        peak_row(fmt::format("{}, seed {}", name, run.seed), run.peak_stress, run.peak_strain, unit));
  if (runs.size() < 2) return;
  const Spread stress = spread_of(runs, &SeedRun::peak_stress);
  const Spread strain = spread_of(runs, &SeedRun::peak_strain);
  rows.push_back(peak_row(name + ", mean", stress.mean, strain.mean, unit));
  rows.push_back(peak_row(name + ", standard deviation", stress.deviation, strain.deviation, unit));
}

std::string peaks_table(const Calibration& calibration) {
  const StrainUnit unit = unit_of(calibration);
  std::vector<std::vector<std::string>> rows;
  add_peaks(rows, "Fitted", calibration.runs, unit);
  add_peaks(rows, "Checked", calibration.further_runs, unit);
  return output::number_table({"Run", "Peak stress (MPa)", "Strain at the peak (" + unit.name + ")"}, rows);
}

std::string search_facts(const CalibrationTask& task, const Calibration& calibration) {
  return output::facts_table(
      {{"Misfit", output::rounded(100 * calibration.misfit, 2), "%"},
       {"Evaluations", output::grouped(static_cast<std::int64_t>(calibration.history.size())), "sets"},
       {"Runs", output::grouped(calibration.run_count), "runs"},
       {"Time", output::rounded(calibration.wall_time), "s"},
       {"Optimiser", name_of_minimizer() + " on the trend of all evaluations"},
       {"Ended because", end_text(task, calibration.end)}});
}

std::string header(const CalibrationTask& task, const Calibration& calibration, const std::string& title) {
  const std::string unmet = why_not_met(task, calibration);
  const std::string setting =
      fmt::format("{} fitted to {}", output::capitalised(output::name_of_loading(task.settings.scene)),
                  target_text(task.target));
  return fmt::format("<header>\n<h1>{}</h1>\n<p class=\"setting\">{}</p>\n</header>\n", output::escape(title),
                     output::escape(setting)) +
         (unmet.empty() ? ""
                        : output::section("Not met", output::paragraph(output::capitalised(unmet) + ".")));
}

constexpr const char* curves_caption =
    "Every line is a run with random strengths of its own. The fitted ones are those that the search saw; "
    "those "
    "checked were run with other seeds afterwards.";

constexpr const char* search_caption =
    "Root mean square of what is left between runs and target, over the target. Every set of parameters was "
    "run with the same seeds.";

}  // namespace

std::string calibration_html(const CalibrationTask& task, const Calibration& calibration,
                             const std::string& title, const std::string& scene_toml) {
  using output::section;
  return output::page(
      title,
      header(task, calibration, title) +
          section("Target and fit",
                  output::side_by_side(
                      "lead", output::chart_figure(curves_chart(task, calibration), 590, 400, curves_caption),
                      search_facts(task, calibration))) +
          section("Parameters", parameters_table(task, calibration)) +
          section("Peaks", peaks_table(calibration)) +
          section("Search", output::chart_figure(search_chart(calibration), 590, 300, search_caption)) +
          section("Scene", output::folded("The fitted scene, with every default written out", scene_toml)));
}

}  // namespace app
