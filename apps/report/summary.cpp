// summary.json.
#include <fmt/format.h>
#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/deformed_picture.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/run_record.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/version.hpp"
#include "libmpm/solver/checkpoint.hpp"
#include "specimen/body/files.hpp"
#include "specimen/describe/doubts.hpp"

namespace {

using nlohmann::json;

json failures_of(const RunRecord& record) {
  json rows = json::array();
  const auto add = [&](const output::FailureCount& count) {
    rows.push_back({{"phase", count.phase},
                    {"points", count.points},
                    {"tension", count.tension},
                    {"shear", count.shear},
                    {"crushed", count.crushed}});
  };
  const std::vector<output::FailureCount> by_phase = output::failures_by_phase(record);
  for (const output::FailureCount& count : by_phase) add(count);
  if (!record.scene.extra_points.empty()) add(output::failures_of_extra_points(record, by_phase));
  return rows;
}

json pictures_of(const mpm::Result& result) {
  json pictures = json::array();
  const bool peak = mpm::peak_reached(result);
  for (const output::DamageStage& stage : output::damage_stages(result).drawn)
    pictures.push_back({{"file", output::picture_name(stage.percent, false)},
                        {"colour_file", output::picture_name(stage.percent, true)},
                        {"percent_of_peak_strain", peak ? json(stage.percent) : json(nullptr)},
                        {"percent_of_strain_at_largest_stress", stage.percent},
                        {"strain", stage.strain},
                        {"tension_failures", stage.tension},
                        {"shear_failures", stage.shear}});
  return pictures;
}

json specimen_of(const specimen::Specimen& specimen) {
  json fractions = json::object();
  for (const auto& [phase, share] : output::phase_shares(specimen.mask)) fractions[phase] = share;
  return {{"rows", specimen.mask.labels.rows},
          {"cols", specimen.mask.labels.cols},
          {"pixel_size_m", specimen.mask.pixel_size},
          {"width_m", specimen.mask.width()},
          {"height_m", specimen.mask.height()},
          {"inclusions", specimen.inclusions.size()},
          {"phase_fractions", fractions},
          {"source", specimen.provenance.source},
          {"source_sha256", specimen.provenance.sha256},
          {"seed", specimen.provenance.seed}};
}

/// Between platens, or in flight.
json loading_of(const mpm::Scene& scene) {
  const mpm::Loading& loading = scene.loading;
  if (loading.direction == mpm::Direction::none)
    return {{"direction", output::word_of(loading.direction)},
            {"initial_velocity_x_m_per_s", loading.initial_velocity_x},
            {"initial_velocity_y_m_per_s", loading.initial_velocity_y}};
  if (scene.fixture.has_loads()) return {{"direction", "loads"}, {"path", output::word_of(loading.path)}};
  json all{{"direction", output::word_of(loading.direction)},
           {"platen", output::word_of(loading.platen)},
           {"separation", loading.separation}};
  if (scene.method == mpm::SolverMethod::explicit_)
    all["velocity_m_per_s"] = loading.velocity;
  else
    all["path"] = output::word_of(loading.path);
  return all;
}

/// What the leading load and the gauges read at the largest force, and at the end.
json fixture_of(const RunRecord& record) {
  const auto& rows = record.result.history;
  const auto at = static_cast<std::size_t>(
      std::max_element(rows.begin(), rows.end(),
                       [](const auto& a, const auto& b) { return a.stress < b.stress; }) -
      rows.begin());
  json all = json::object();
  if (record.scene.fixture.has_loads())
    all = {{"largest_force_N", output::leading_force(record.scene, rows[at].stress)},
           {"displacement_at_largest_force_m", output::leading_displacement(record.scene, rows[at].strain)},
           {"end_force_N", output::leading_force(record.scene, rows.back().stress)},
           {"end_displacement_m", output::leading_displacement(record.scene, rows.back().strain)},
           {"thickness_m", record.scene.fixture.thickness}};
  if (record.result.gauges.empty()) return all;
  all["gauges"] = json::array();
  for (const mpm::GaugeReadings& gauge : record.result.gauges)
    all["gauges"].push_back(
        {{"name", gauge.name}, {"at_largest_force_m", gauge.values[at]}, {"end_m", gauge.values.back()}});
  return all;
}

json setting_of(const mpm::Scene& scene) {
  return {{"method", output::word_of(scene.method)},
          {"cell", scene.pixel_cells ? "pixel" : fmt::format("{0} x {0}", scene.points_per_cell)},
          {"kinematics", output::word_of(scene.kinematics)},
          {"plane", output::word_of(scene.plane)},
          {"seed", scene.damage.seed},
          {"crack_closure", output::word_of(scene.damage.crack_closure)},
          {"precision", output::word_of(scene.precision)}};
}

json figures_of(const mpm::Result& result) {
  const mpm::HistoryRow end = result.history.empty() ? mpm::HistoryRow{} : result.history.back();
  json figures = output::peak_figures(result);
  figures.update({{"secant_modulus_Pa", output::secant_modulus(result)},
                  {"end_strain", end.strain},
                  {"end_stress_Pa", end.stress},
                  {"end_time_s", end.time},
                  {"moving_points", end.moving_points},
                  {"left_points", end.left_points},
                  {"tension_failures", result.tension_failures},
                  {"shear_failures", result.shear_failures},
                  {"points", result.points},
                  {"steps", result.steps},
                  {"dt_s", result.dt},
                  {"wall_s", result.wall_time},
                  {"point_updates_per_s", result.point_updates_per_second()},
                  {"energy_error", result.energy_error},
                  {"instruction_set", result.instruction_set},
                  {"threads", result.threads},
                  {"nothing_carries", result.nothing_carries},
                  {"stop_reason", output::word_of(result.stop)}});
  return figures;
}

json inertia_of(const mpm::Result& result) {
  const output::InertiaShares shares = output::inertia_of(output::peak_row(result));
  return {{"peak_imbalance", shares.imbalance},
          {"peak_kinetic_share", shares.kinetic},
          {"peak_damped_share", shares.damped}};
}

json estimate_of(const output::ErrorEstimate& estimate) {
  json all{{"peak_stress_error", estimate.stress_error()},
           {"peak_strain_error", estimate.strain_error()},
           {"wall_s", estimate.wall_time()},
           {"sources", json::array()}};
  for (const output::ErrorSource& source : estimate.sources)
    all["sources"].push_back({{"name", source.name},
                              {"compared_with", source.compared},
                              {"peak_reached", source.peak_reached},
                              {"peak_stress_Pa", source.peak_reached ? json(source.peak_stress) : nullptr},
                              {"peak_strain", source.peak_reached ? json(source.peak_strain) : nullptr},
                              {"peak_stress_error", source.stress_error},
                              {"peak_strain_error", source.strain_error},
                              {"wall_s", source.wall_time}});
  return all;
}

}  // namespace

std::string run_digest(const std::string& scene_toml, const mpm::Scene& scene) {
  std::istringstream lines(scene_toml);
  std::string what_matters;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("threads = ")) what_matters += line + "\n";
  return specimen::sha256_of_text(what_matters + mpm::specimen_digest(scene));
}

json summary(const RunRecord& record) {
  json all = figures_of(record.result);
  if (output::has_platens(record.scene) && !record.result.history.empty())
    all.update(inertia_of(record.result));
  all.update(setting_of(record.scene));
  all.update(loading_of(record.scene));
  if (!record.result.history.empty()) all.update(fixture_of(record));
  all["specimen"] = specimen_of(record.specimen);
  all["failures_by_phase"] = failures_of(record);
  all["damage_pictures"] = pictures_of(record.result);
  if (output::has_end(record.result))
    all["end_picture"] = {{"file", output::deformed_name(false)},
                          {"colour_file", output::deformed_name(true)}};
  if (!record.error_estimate.sources.empty()) all["error_estimate"] = estimate_of(record.error_estimate);
  all["notes"] = output::all_notes(record);
  all["warnings"] = specimen::doubts_of(record.specimen);
  all["title"] = record.title;
  all["scene_hash"] = record.scene_hash;
  all["run"] = run_digest(record.scene_toml, record.scene);
  all["version"] = app::version();
  return all;
}
