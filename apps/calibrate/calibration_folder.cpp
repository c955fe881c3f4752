#include "apps/calibrate/calibration_folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "apps/calibrate/calibration.hpp"
#include "apps/calibrate/calibration_report.hpp"
#include "apps/calibrate/trend_search.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/version.hpp"
#include "libmpm/files/replace_file.hpp"
#include "specimen/describe/doubts.hpp"

namespace app {
namespace {

std::string wanted_free(const CalibrationWish& wish, const Target& target) {
  if (!wish.free.empty()) return wish.free;
  if (!target.curve.empty()) return "tensile_scale,young,weibull_modulus";
  if (!target.peak_strain) return "tensile_scale";
  return target.peak_stress ? "tensile_scale,young" : "young";
}

}  // namespace

Target read_target(const CalibrationWish& wish, Curve measured) {
  const bool peak = !wish.peak_stress.empty() || !wish.peak_strain.empty();
  if (peak != (wish.curve.empty() && measured.empty()))
    throw Rejected(Exit::usage, option_name("target"), peak ? "given beside a peak" : "no target is given",
                   fmt::format("a target is {}, {} or both, or {} CURVE.csv", option_name("peak-stress"),
                               option_name("peak-strain"), option_name("target")));
  Target target;
  target.curve = wish.curve.empty() ? std::move(measured) : read_target_curve(wish.curve);
  if (!wish.peak_stress.empty())
    target.peak_stress =
        read_option("peak-stress", wish.peak_stress, QuantityCodec{Dimension::pressure, above(0)});
  if (!wish.peak_strain.empty())
    target.peak_strain =
        read_option("peak-strain", wish.peak_strain, QuantityCodec{Dimension::ratio, inside(0, 1)});
  return target;
}

void check_loading(const mpm::Scene& scene) {
  if (scene.loading.direction != mpm::Direction::none) return;
  throw Rejected(Exit::data, "loading.direction", "none",
                 "must be tension or compression: a peak is that of a "
                 "stress-strain curve between platens");
}

CalibrationTask make_task(const Job& job, Target target, const CalibrationWish& wish) {
  auto parameters = parse_free(wanted_free(wish, target), job.settings, job.scene);
  CalibrationTask task{job.settings, job.specimen, std::move(target), std::move(parameters)};
  task.seeds = read_option("seeds", wish.seeds, IntegerCodec<>{between(1, 1000)});
  task.evaluations = read_option("max-evaluations", wish.evaluations, IntegerCodec<>{between(1, 100000)});
  task.tolerance = read_option("tolerance", wish.tolerance, QuantityCodec{Dimension::ratio, inside(0, 1)});
  return task;
}

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json target_json(const Target& target) {
  if (target.curve.empty())
    return {{"peak_stress_Pa", number_or_null(target.peak_stress)},
            {"peak_strain", number_or_null(target.peak_strain)}};
  const bool peak = target.curve.has_peak();
  const double stress = target.curve.peak_stress(), strain = target.curve.peak_strain();
  return {{"peak_stress_Pa", peak ? Json(stress) : Json(nullptr)},
          {"peak_strain", peak ? Json(strain) : Json(nullptr)},
          {"largest_stress_Pa", stress},
          {"strain_at_largest_stress", strain},
          {"curve", {{"strain", target.curve.strain}, {"stress_Pa", target.curve.stress}}}};
}

Json settings_json(const FreeParameter& parameter, double factor) {
  Json settings = Json::array();
  for (const ScaledSetting& setting : parameter.settings)
    settings.push_back({{"key", setting.field.key},
                        {"start", setting.start},
                        {"low", setting.value(parameter.low)},
                        {"high", setting.value(parameter.high)},
                        {"best", setting.value(factor)},
                        {"best_text", setting.text(factor)}});
  return settings;
}

Json parameters_json(const CalibrationTask& task, const Calibration& calibration) {
  const auto spread = parameter_spread(task, calibration);
  const std::vector<double>& factors = calibration.best_evaluation().factors;
  Json parameters = Json::array();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const FreeParameter& parameter = task.parameters[i];
    parameters.push_back(
        {{"name", parameter.name},
         {"factor", factors[i]},
         {"factor_low", parameter.low},
         {"factor_high", parameter.high},
         {"at_bound", is_at_low_bound(parameter, factors[i]) || is_at_high_bound(parameter, factors[i])},
         {"relative_standard_deviation", spread ? Json((*spread)[i]) : Json(nullptr)},
         {"settings", settings_json(parameter, factors[i])}});
  }
  return parameters;
}

/// Standard deviations of a single run are unknown.
Json peaks_json(const std::vector<SeedRun>& runs) {
  if (runs.empty()) return nullptr;
  const Spread stress = spread_of_peaks(runs, &SeedRun::peak_stress);
  const Spread strain = spread_of_peaks(runs, &SeedRun::peak_strain);
  const std::size_t without = count_without_peak(runs);
  const auto known = [&](double deviation) {
    return runs.size() > without + 1 ? Json(deviation) : Json(nullptr);
  };
  Json each = Json::array();
  for (const SeedRun& run : runs)
    each.push_back({{"seed", run.seed},
                    {"peak_reached", run.peak_reached},
                    {"peak_stress_Pa", run.peak_reached ? Json(run.peak_stress) : Json(nullptr)},
                    {"peak_strain", run.peak_reached ? Json(run.peak_strain) : Json(nullptr)},
                    {"largest_stress_Pa", run.peak_stress},
                    {"strain_at_largest_stress", run.peak_strain}});
  return {{"without_peak", without},
          {"peak_stress_mean_Pa", stress.mean},
          {"peak_stress_standard_deviation_Pa", known(stress.deviation)},
          {"peak_strain_mean", strain.mean},
          {"peak_strain_standard_deviation", known(strain.deviation)},
          {"runs", each}};
}

Json history_json(const Calibration& calibration) {
  Json history = Json::array();
  for (const Evaluation& evaluation : calibration.history)
    history.push_back({{"factors", evaluation.factors},
                       {"misfit", evaluation.misfit},
                       {"peak_stress_Pa", evaluation.peak.stress},
                       {"peak_strain", evaluation.peak.strain},
                       {"aims_at", evaluation.coarse ? "peak of the curve" : "target"}});
  return history;
}

}  // namespace

Json calibration_json(const CalibrationTask& task, const Calibration& calibration) {
  const std::string unmet = why_not_met(task, calibration), doubt = doubt_of(task.target);
  return {{"target", target_json(task.target)},
          {"met", unmet.empty()},
          {"warnings", specimen::doubts_of(task.specimen)},
          {"doubt", doubt.empty() ? Json(nullptr) : Json(doubt)},
          {"why_not_met", unmet.empty() ? Json(nullptr) : Json(unmet)},
          {"misfit", calibration.misfit},
          {"parameters", parameters_json(task, calibration)},
          {"fitted", peaks_json(calibration.runs)},
          {"checked_with_further_seeds", peaks_json(calibration.further_runs)},
          {"optimiser", name_of_minimizer() + " on the trend of all evaluations"},
          {"tolerance", task.tolerance},
          {"ended_because", end_text(task, calibration.end)},
          {"evaluations", calibration.history.size()},
          {"runs", calibration.run_count},
          {"wall_s", calibration.wall_time},
          {"history", history_json(calibration)},
          {"version", version()}};
}

Attempts write_calibration(const std::filesystem::path& folder, const CalibrationTask& task,
                           const Calibration& calibration) {
  const std::string toml = scene_text(calibration.settings, Extent::whole, folder);
  Attempts attempt;
  const auto write = [&](const char* name, const std::string& text) {
    attempt([&] { mpm::replace_file((folder / name).string(), text); });
  };
  write("scene.toml", toml);
  write("calibration.json", json_text(calibration_json(task, calibration)));
  write("report.html", calibration_html(task, calibration, "Calibration: " + task.settings.title, toml));
  return attempt;
}

}  // namespace app
