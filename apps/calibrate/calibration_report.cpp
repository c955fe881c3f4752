#include "apps/calibrate/calibration_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/calibrate/calibration.hpp"
#include "apps/calibrate/trend_search.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {
namespace {

constexpr double close_peak = 0.02;
constexpr double close_curve = 0.1;

std::string stress_text(double stress) { return fmt::format("{:.4g} MPa", 1e-6 * stress); }

std::string peak_text(const Peak& peak) {
  return fmt::format("{} at strain {}", stress_text(peak.stress), strain_text(peak.strain));
}

/// Of the mean of runs, relative.
double standard_error(const std::vector<SeedRun>& runs, double SeedRun::*figure) {
  const Spread spread = spread_of_peaks(runs, figure);
  return spread.deviation / spread.mean /
         std::sqrt(static_cast<double>(runs.size() - count_without_peak(runs)));
}

bool is_met(const Target& target, const Calibration& calibration, bool at_bound) {
  if (!target.curve.empty()) return !at_bound || calibration.misfit <= close_curve;
  const auto close = [&](const std::optional<double>& wanted, double SeedRun::*figure) {
    const double allowed =
        at_bound ? close_peak : std::max(close_peak, standard_error(calibration.runs, figure));
    return !wanted || std::abs(spread_of_peaks(calibration.runs, figure).mean / *wanted - 1) <= allowed;
  };
  return close(target.peak_stress, &SeedRun::peak_stress) && close(target.peak_strain, &SeedRun::peak_strain);
}

std::vector<std::string> active_bounds(const CalibrationTask& task, const std::vector<double>& factors) {
  std::vector<std::string> bounds;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const FreeParameter& parameter = task.parameters[i];
    const ScaledSetting& first = parameter.settings.front();
    if (is_at_low_bound(parameter, factors[i]))
      bounds.push_back(
          fmt::format("{} at its lower bound of {}", first.field.key, first.text(parameter.low)));
    if (is_at_high_bound(parameter, factors[i]))
      bounds.push_back(
          fmt::format("{} at its upper bound of {}", first.field.key, first.text(parameter.high)));
  }
  return bounds;
}

std::string seeds_text(const std::vector<SeedRun>& runs) {
  if (runs.size() == 1) return fmt::format("seed {}", runs.front().seed);
  return fmt::format("seeds {} to {}", runs.front().seed, runs.back().seed);
}

std::string nearest_peak(const std::vector<SeedRun>& runs) {
  if (count_without_peak(runs) == runs.size()) return "no peak at all";
  return "a peak of " + peak_text({spread_of_peaks(runs, &SeedRun::peak_stress).mean,
                                   spread_of_peaks(runs, &SeedRun::peak_strain).mean});
}

std::string runs_line(const std::vector<SeedRun>& runs) {
  const std::size_t without = count_without_peak(runs);
  if (without == runs.size())
    return fmt::format("no peak, largest stress {} ({}), where the runs ended", peak_text(mean_peak(runs)),
                       seeds_text(runs));
  const Spread stress = spread_of_peaks(runs, &SeedRun::peak_stress);
  const Spread strain = spread_of_peaks(runs, &SeedRun::peak_strain);
  std::string line = fmt::format("peak {} ({}", peak_text({stress.mean, strain.mean}), seeds_text(runs));
  if (runs.size() > without + 1)
    line += fmt::format("; standard deviation {} and {}", stress_text(stress.deviation),
                        strain_text(strain.deviation));
  if (without > 0) line += fmt::format("; without {} that reached no peak", without);
  return line + ")";
}

}  // namespace

std::string target_text(const Target& target) {
  if (!target.curve.empty())
    return fmt::format("a curve to strain {} {} {}", strain_text(target.curve.last_strain()),
                       target.curve.has_peak() ? "with its peak of" : "without a peak, largest stress",
                       peak_text({target.curve.peak_stress(), target.curve.peak_strain()}));
  if (!target.peak_strain) return "a peak of " + stress_text(*target.peak_stress);
  if (!target.peak_stress) return "a peak at strain " + strain_text(*target.peak_strain);
  return "a peak of " + peak_text({*target.peak_stress, *target.peak_strain});
}

std::vector<std::string> setting_texts(const FreeParameter& parameter, double factor) {
  std::vector<std::string> texts;
  for (const ScaledSetting& setting : parameter.settings)
    texts.push_back(fmt::format("{} = {}", setting.field.key, setting.text(factor)));
  return texts;
}

std::string end_text(const CalibrationTask& task, SearchEnd end) {
  switch (end) {
    case SearchEnd::goal:
      return fmt::format("the misfit came below {:.3g} %", 100 * task.tolerance);
    case SearchEnd::no_progress:
      return "the last evaluations brought nothing better";
    case SearchEnd::evaluations:
      return fmt::format("{} evaluations were made", task.evaluations);
    case SearchEnd::stopped:
      return "it was interrupted";
  }
  return {};
}

std::string why_not_met(const CalibrationTask& task, const Calibration& calibration) {
  const std::vector<std::string> bounds = active_bounds(task, calibration.best_evaluation().factors);
  if (is_met(task.target, calibration, !bounds.empty())) return {};
  const bool curve = !task.target.curve.empty();
  const std::string nearest =
      curve ? fmt::format("a misfit of {:.3g} %", 100 * calibration.misfit) : nearest_peak(calibration.runs);
  const std::string reason =
      bounds.empty() ? "these parameters alone do not reach it; free others" : listed(bounds, "and");
  return fmt::format("the target, {}, was not met; the nearest is {}; {}", target_text(task.target), nearest,
                     reason);
}

std::string doubt_of(const Target& target) {
  if (target.curve.empty() || target.curve.has_peak()) return {};
  return fmt::format(
      "the measured curve has no peak: its stress has not fallen again at its end, {}; what is fitted is the "
      "rise alone, and strengths beyond those found fit it as well",
      strain_text(target.curve.last_strain()));
}

std::vector<std::string> outcome_lines(const CalibrationTask& task, const Calibration& calibration) {
  std::vector<std::string> lines;
  const auto spread = parameter_spread(task, calibration);
  const std::vector<double>& factors = calibration.best_evaluation().factors;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string deviation = spread ? fmt::format(" +- {:.2g} %", 100 * (*spread)[i]) : "";
    lines.push_back(fmt::format("{} x {:.4g}{}: {}", task.parameters[i].name, factors[i], deviation,
                                listed(setting_texts(task.parameters[i], factors[i]), "and")));
  }
  lines.push_back(runs_line(calibration.runs));
  if (!calibration.further_runs.empty()) lines.push_back("checked: " + runs_line(calibration.further_runs));
  lines.push_back(fmt::format("misfit {:.2g} % after {} evaluations and {} runs in {:.1f} s: {}",
                              100 * calibration.misfit, calibration.history.size(), calibration.run_count,
                              calibration.wall_time, end_text(task, calibration.end)));
  return lines;
}

std::string evaluation_text(const CalibrationTask& task, const Calibration& so_far) {
  const Evaluation& last = so_far.history.back();
  std::string text = fmt::format("evaluation {}   misfit {:.2f} %   best {:.2f} %  ", so_far.history.size(),
                                 100 * last.misfit, 100 * so_far.best_evaluation().misfit);
  for (std::size_t i = 0; i < last.factors.size(); ++i)
    text += fmt::format(" {} x {:.3f}", task.parameters[i].name, last.factors[i]);
  return text;
}

namespace {

using output::Chart;
using output::Ink;
using output::Series;
using output::StrainUnit;

/// Beyond, a broken specimen only trembles, and hides what was fitted.
double last_strain_shown(const Target& target, const Calibration& calibration) {
  double farthest = 0;
  for (const auto* runs : {&calibration.runs, &calibration.further_runs})
    for (const SeedRun& run : *runs) farthest = std::max(farthest, 2 * run.peak_strain);
  return target.curve.empty() ? farthest : 1.1 * target.curve.last_strain();
}

StrainUnit unit_of(const Calibration& calibration) {
  double largest = 0;
  for (const SeedRun& run : calibration.runs) largest = std::max(largest, run.curve.last_strain());
  return output::strain_unit(largest);
}

void add_curve(Series& series, const Curve& curve, const StrainUnit& unit, double last_strain) {
  const auto end = std::upper_bound(curve.strain.begin(), curve.strain.end(), last_strain);
  output::add_line(series, {curve.strain.begin(), end}, curve.stress, unit.per_strain, 1e-6);
}

/// The curves of several runs as one line with gaps.
Series runs_series(const std::string& name, Ink ink, const std::vector<SeedRun>& runs, const StrainUnit& unit,
                   double last_strain) {
  Series series{name + ", " + counted(std::ssize(runs), "seed"), {}, {}, ink};
  for (const SeedRun& run : runs) add_curve(series, run.curve, unit, last_strain);
  return series;
}

Series target_curve_series(const Curve& curve, const StrainUnit& unit) {
  Series series{"target", {}, {}, Ink::text, true};
  add_curve(series, curve, unit, curve.last_strain());
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
    rows.push_back(peak_row(fmt::format("{}, seed {}{}", name, run.seed, run.peak_reached ? "" : ", no peak"),
                            run.peak_stress, run.peak_strain, unit));
  if (runs.size() < count_without_peak(runs) + 2) return;
  const Spread stress = spread_of_peaks(runs, &SeedRun::peak_stress);
  const Spread strain = spread_of_peaks(runs, &SeedRun::peak_strain);
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
  const auto said = [](const char* heading, const std::string& text) {
    return text.empty() ? "" : output::section(heading, output::paragraph(output::capitalised(text) + "."));
  };
  return output::heading(title, setting) + said("Not met", unmet) + said("No peak", doubt_of(task.target)) +
         output::warnings_section(specimen::doubts_of(task.specimen));
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
  const auto standing = [](const char* heading, const auto& make) {
    return output::standing(heading, [&] { return section(heading, make()); });
  };
  return output::page(
      title,
      header(task, calibration, title) + standing("Target and fit", [&] {
        return output::side_by_side(
            "lead", output::chart_figure(curves_chart(task, calibration), 590, 400, curves_caption),
            search_facts(task, calibration));
      }) + standing("Parameters", [&] {
        return parameters_table(task, calibration);
      }) + standing("Peaks", [&] {
        return peaks_table(calibration);
      }) + standing("Search", [&] {
        return output::chart_figure(search_chart(calibration), 590, 300, search_caption);
      }) + section("Scene", output::folded("The fitted scene, with every default written out", scene_toml)));
}

}  // namespace app
