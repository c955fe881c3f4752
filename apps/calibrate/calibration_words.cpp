#include "apps/calibrate/calibration_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/calibrate/parameter_spread.hpp"
#include "apps/text/strain_text.hpp"
#include "apps/text/suggestion.hpp"

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
  const Spread spread = spread_of(runs, figure);
  return spread.deviation / spread.mean / std::sqrt(static_cast<double>(runs.size()));
}

bool is_met(const Target& target, const Calibration& calibration, bool at_bound) {
  if (!target.curve.empty()) return !at_bound || calibration.misfit <= close_curve;
  const auto close = [&](const std::optional<double>& wanted, double SeedRun::*figure) {
    const double allowed =
        at_bound ? close_peak : std::max(close_peak, standard_error(calibration.runs, figure));
    return !wanted || std::abs(spread_of(calibration.runs, figure).mean / *wanted - 1) <= allowed;
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

std::string runs_line(const std::vector<SeedRun>& runs) {
  std::string line = fmt::format("peak {} ({}", peak_text(mean_peak(runs)), seeds_text(runs));
  if (runs.size() > 1)
    line += fmt::format("; standard deviation {} and {}",
                        stress_text(spread_of(runs, &SeedRun::peak_stress).deviation),
                        strain_text(spread_of(runs, &SeedRun::peak_strain).deviation));
  return line + ")";
}

}  // namespace

std::string target_text(const Target& target) {
  if (!target.curve.empty())
    return fmt::format("a curve to strain {} with its peak of {}", strain_text(target.curve.last_strain()),
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
  const std::string nearest = curve ? fmt::format("a misfit of {:.3g} %", 100 * calibration.misfit)
                                    : "a peak of " + peak_text(mean_peak(calibration.runs));
  const std::string reason =
      bounds.empty() ? "these parameters alone do not reach it; free others" : listed(bounds, "and");
  return fmt::format("the target, {}, was not met; the nearest is {}; {}", target_text(task.target), nearest,
                     reason);
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

}  // namespace app
