// What the features cost, as text, page and table.
#include "apps/bench/feature_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "apps/job/job.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/reproduce/trial.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/version.hpp"
#include "libmpm/run/simulate.hpp"

namespace app::bench {
namespace {

using mpm::kernels::Check;

/// The paper's specimen, pulled so fast that some hundred steps take it to where points fail.
mpm::Scene feature_specimen(int pixels, mpm::Kinematics kinematics) {
  const double pixel = 150.0 / pixels;  // [mm]
  const reproduce::Trial trial{"tension", {{"generate.pixel_size", std::to_string(pixel) + " mm"}}, false};
  mpm::Scene scene = make_job(reproduce::settings_of(trial)).scene;
  scene.threads = 1;
  scene.kinematics = kinematics;
  scene.loading.velocity = 1;
  scene.loading.ramp_time = 20e-6;
  scene.loading.stop_strain = kinematics == mpm::Kinematics::moving ? 3e-4 : 6e-4;
  return scene;
}

mpm::Scene with_limits(mpm::Scene scene, bool can_crack) {
  for (auto& phase : scene.phases)
    if (phase) {
      phase->cohesion = mpm::Phase::unbreakable;
      if (!can_crack) phase->tensile_scale = mpm::Phase::unbreakable;
    }
  return scene;
}

void check_all(mpm::Plan& plan) {
  plan.features.check = plan.moving.features.check = Check::tension_and_shear;
  plan.moving.optional.tension = plan.moving.optional.crush = true;
}

/// Features that both kinematics may leave out.
void add_common(std::vector<FeatureCase>& cases, int pixels, mpm::Kinematics kinematics) {
  const std::string name = kinematics == mpm::Kinematics::moving ? "moving points" : "small strain";
  const auto whole = [=] { return feature_specimen(pixels, kinematics); };
  const auto cracking = [=] { return with_limits(whole(), true); };
  const auto elastic = [=] { return with_limits(whole(), false); };
  cases.push_back({"tension test", name, "nothing can fail", elastic,
                   [](mpm::Plan& plan) {
                     plan.features.check = plan.moving.features.check = Check::tension;
                     plan.moving.optional.tension = true;
                   },
                   1e-9});
  cases.push_back({"shear test", name, "nothing can fail in shear", cracking, check_all, 1e-9});
  cases.push_back({"crack closure", name, "nothing can crack", elastic,
                   [](mpm::Plan& plan) {
                     check_all(plan);
                     plan.features.crack_closure = plan.moving.features.crack_closure = true;
                     plan.moving.optional.cracked = true;
                   },
                   1e-9});
  cases.push_back({"local damping", name, "nothing is damped", whole,
                   [](mpm::Plan& plan) { plan.features.damping = plan.moving.features.damping = true; },
                   1e-9});
  cases.push_back({"energies at every step", name, "a row of the history holds many steps", whole,
                   [](mpm::Plan& plan) { plan.steps_per_row = 1; }, 1e-9});
}

void add_moving(std::vector<FeatureCase>& cases, int pixels) {
  const auto whole = [=] { return feature_specimen(pixels, mpm::Kinematics::moving); };
  cases.push_back({"deformation gradient", "moving points", "nobody asked for it", whole,
                   [](mpm::Plan& plan) { plan.moving.optional.deformation = true; }, 1e-9});
  cases.push_back({"blend with PIC", "moving points", "all is FLIP", whole,
                   [](mpm::Plan& plan) { plan.moving.features.transfer = mpm::moving::Return::blend; },
                   1e-6});
}

double time_of(const mpm::Result& result) {
  return result.wall_time / (static_cast<double>(result.points) * static_cast<double>(result.steps));
}

/// Largest difference of the stress at rows of one time, over the peak. The rows at rest say nothing.
double difference_of(const mpm::Result& lean, const mpm::Result& full) {
  double largest = 0;
  std::size_t at = 1;
  for (std::size_t i = 1; i < lean.history.size(); ++i) {
    const mpm::HistoryRow& row = lean.history[i];
    while (at < full.history.size() && full.history[at].time < row.time) ++at;
    if (at == full.history.size() || full.history[at].time != row.time) return 1;  // it took other steps
    largest = std::max(largest, std::abs(full.history[at].stress - row.stress));
  }
  return largest / lean.peak_stress;
}

/// An elastic run has no maps.
bool same_maps(const mpm::Result& lean, const mpm::Result& full) {
  if (lean.tension_failures != full.tension_failures || lean.shear_failures != full.shear_failures)
    return false;
  if (lean.failure_strain.size() != full.failure_strain.size()) return lean.tension_failures == 0;
  return std::equal(lean.failure_mode.data(), lean.failure_mode.data() + lean.failure_mode.size(),
                    full.failure_mode.data());
}

FeatureCost measure(const FeatureCase& it, int repeats) {
  const mpm::Scene scene = it.make();
  const mpm::Plan lean_plan = mpm::plan(scene);
  mpm::Plan full_plan = lean_plan;
  it.add(full_plan);
  FeatureCost cost{it.feature, it.kinematics, it.scene, 0, 0, 0, true, it.tolerance};
  std::vector<double> without, with;
  for (int i = 0; i < repeats; ++i) {
    const mpm::Result lean = mpm::simulate(scene, lean_plan);
    const mpm::Result full = mpm::simulate(scene, full_plan);
    without.push_back(time_of(lean));
    with.push_back(time_of(full));
    if (i > 0) continue;
    cost.difference = difference_of(lean, full);
    cost.same_failures = same_maps(lean, full);
  }
  cost.time_without = quantile_of(without, 0.5);
  cost.time_with = quantile_of(with, 0.5);
  return cost;
}

}  // namespace

std::vector<FeatureCase> all_features(int pixels) {
  std::vector<FeatureCase> cases;
  add_common(cases, pixels, mpm::Kinematics::small_strain);
  cases.push_back({"second elastic constant", "small strain", "all phases share Poisson's ratio",
                   [=] { return feature_specimen(pixels, mpm::Kinematics::small_strain); },
                   [](mpm::Plan& plan) { plan.features.one_poisson_ratio = false; }, 1e-6});
  add_common(cases, pixels, mpm::Kinematics::moving);
  add_moving(cases, pixels);
  return cases;
}

std::vector<FeatureCost> measure_features(const std::vector<FeatureCase>& cases, int repeats,
                                          const Watch& watch) {
  std::vector<FeatureCost> costs;
  for (const FeatureCase& it : cases) {
    if (!watch.goes_on()) break;
    costs.push_back(measure(it, repeats));
    watch.tell(costs.size(), cases.size());
  }
  return costs;
}

namespace {

constexpr const char* feature_title = "What features cost";

double nanoseconds(double seconds) { return 1e9 * seconds; }

std::string agreement_text(const FeatureCost& cost) {
  if (!cost.same_failures) return "NO: other points fail";
  return (cost.agrees() ? "to " : "NO: off by ") + output::rounded(cost.difference, 1);
}

}  // namespace

std::string feature_text(const std::vector<FeatureCost>& costs) {
  std::string text = fmt::format("{:24} {:14} {:>8} {:>8} {:>8}   {}\n", "feature", "kinematics", "without",
                                 "with", "costs", "results agree");
  for (const FeatureCost& cost : costs)
    text += fmt::format("{:24} {:14} {:8.2f} {:8.2f} {:+8.2f}   {}\n", cost.feature, cost.kinematics,
                        nanoseconds(cost.time_without), nanoseconds(cost.time_with),
                        nanoseconds(cost.time_with - cost.time_without), agreement_text(cost));
  return text + "times in ns a point and step, on one core\n";
}

std::string feature_html(const std::vector<FeatureCost>& costs) {
  std::vector<std::vector<std::string>> rows;
  for (const FeatureCost& cost : costs)
    rows.push_back({cost.feature + ", " + cost.kinematics, cost.scene,
                    output::with_decimals(nanoseconds(cost.time_without), 2),
                    output::with_decimals(nanoseconds(cost.time_with), 2),
                    output::percent(cost.time_with / cost.time_without - 1), agreement_text(cost)});
  return output::page(
      feature_title,
      output::heading(
          feature_title,
          fmt::format("Runs by mesopix {} of the paper's specimen that do without a feature, and the "
                      "same runs with the feature compiled in all the same.",
                      version())) +
          output::section(
              "Nanoseconds a point and step, on one core",
              output::number_table({"Feature", "Left out where", "Without", "With", "Costs", "Results agree"},
                                   rows) +
                  output::remarks(output::paragraph(
                      "Medians of runs that took turns. Results agree when the same points fail in the "
                      "same way and the stress differs by rounding, over its peak."))));
}

std::string feature_csv(const std::vector<FeatureCost>& costs) {
  std::string csv = "feature,kinematics,scene,without_s,with_s,difference,same_failures,agrees\n";
  for (const FeatureCost& cost : costs)
    csv += fmt::format("{},{},{},{},{},{},{:d},{:d}\n", cost.feature, cost.kinematics, cost.scene,
                       output::exact(cost.time_without), output::exact(cost.time_with),
                       output::exact(cost.difference), cost.same_failures, cost.agrees());
  return csv;
}

}  // namespace app::bench
