#include "apps/reproduce/sweep.hpp"

#include <fmt/format.h>

#include <array>
#include "apps/text/words.hpp"

#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

constexpr double dropped = 0.5;             ///< share of the peak
constexpr double itz_strength_share = 0.6;  ///< strength of the ITZ over that of the mortar, Table 1

int repeats_of(const Case& test, const Effort& effort) {
  return test.repeats > 0 ? test.repeats : effort.repeats;
}

Trial trial_of(const Sweep& sweep, const Case& test, const Effort& effort, double value, int seed) {
  std::vector<Setting> settings = test.settings;
  if (value != sweep.table1)  // else it is the scene as it stands, which other figures run too
    for (const Setting& setting : sweep.settings(value)) settings.push_back(setting);
  return square_trial(effort, test.scene, seed, settings);
}

double shear_share(const mpm::Result& result) {
  const auto all = static_cast<double>(result.tension_failures + result.shear_failures);
  return static_cast<double>(result.shear_failures) / all;
}

CaseResult result_of(const Sweep& sweep, const Case& test, const Effort& effort,
                     const TrialResults& outcomes) {
  CaseResult result{test.name, repeats_of(test, effort), sweep.values, {}, {}, {}, {}, {}};
  for (const double value : sweep.values) {
    std::vector<double> stresses, strains, drops, shears;
    for (int seed = 1; seed <= result.specimens; ++seed) {
      const mpm::Result& run = outcomes.of(trial_of(sweep, test, effort, value, seed)).result;
      stresses.push_back(peak_of(run, &mpm::Result::peak_stress));
      strains.push_back(peak_of(run, &mpm::Result::peak_strain));
      drops.push_back(drop_ratio(run, dropped));
      shears.push_back(shear_share(run));
      if (seed == 1) result.first.push_back(&run);
    }
    result.peak_stress.push_back(spread_of(stresses));
    result.peak_strain.push_back(spread_of(strains));
    result.drop.push_back(spread_of(drops).mean);
    result.shear_share.push_back(spread_of(shears).mean);
  }
  return result;
}

std::string value_text(const Sweep& sweep, double value) {
  return sweep.symbol + " = " + output::concise(value) + (sweep.unit.empty() ? "" : " " + sweep.unit);
}

output::Chart chart_of(const Sweep& sweep, const CaseResult& result) {
  output::Chart chart{"Curves in " + result.name, {"Strain", "microstrain"}, {"Stress", "MPa"}, {}, {}};
  for (std::size_t i = 0; i < result.values.size(); ++i)
    chart.series.push_back(output::stress_series(value_text(sweep, result.values[i]),
                                                 output::ink_of_series(i), *result.first[i]));
  return chart;
}

std::string table_of(const Sweep& sweep, const CaseResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < result.values.size(); ++i)
    rows.push_back({value_text(sweep, result.values[i]), output::rounded(1e-6 * result.peak_stress[i].mean),
                    output::rounded(1e6 * result.peak_strain[i].mean), output::rounded(result.drop[i]),
                    output::percent(result.shear_share[i])});
  return output::number_table({"", "Peak MPa", "at 10⁻⁶", "Drop", "Shear"}, rows);
}

std::string case_html(const Sweep& sweep, const CaseResult& result) {
  return "<h3>" + output::capitalised(result.name) + "</h3>\n" +
         output::chart_figure(chart_of(sweep, result), 480, 350,
                              "Curves of the first specimen; below, the mean of " +
                                  counted(result.specimens, "specimen") + ".") +
         table_of(sweep, result);
}

}  // namespace

std::vector<double> CaseResult::mean_stress() const {
  std::vector<double> means;
  for (const Spread& spread : peak_stress) means.push_back(spread.mean);
  return means;
}

std::vector<Trial> trials_of(const Sweep& sweep, const Effort& effort) {
  std::vector<Trial> trials;
  for (const Case& test : sweep.cases)
    for (const double value : sweep.values)
      for (int seed = 1; seed <= repeats_of(test, effort); ++seed)
        trials.push_back(trial_of(sweep, test, effort, value, seed));
  return trials;
}

std::vector<CaseResult> results_of(const Sweep& sweep, const Effort& effort, const TrialResults& outcomes) {
  std::vector<CaseResult> results;
  for (const Case& test : sweep.cases) results.push_back(result_of(sweep, test, effort, outcomes));
  return results;
}

std::string sweep_html(const Sweep& sweep, const std::vector<CaseResult>& results) {
  std::vector<std::string> cases;
  for (const CaseResult& result : results) cases.push_back(case_html(sweep, result));
  return output::in_pairs(cases) +
         output::remarks(output::paragraph(
             "Drop: strain at which the stress has fallen to half its peak, over the strain at the peak; "
             "the nearer to 1, the more brittle. Shear: share of all failures up to the end of the run."));
}

nlohmann::json sweep_json(const std::vector<CaseResult>& results) {
  nlohmann::json json;
  for (const CaseResult& result : results) {
    nlohmann::json& one = json[result.name];
    one = {{"values", result.values},
           {"specimens", result.specimens},
           {"drop", result.drop},
           {"shear_share", result.shear_share}};
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      one["peak_stress_Pa"].push_back(json_of(result.peak_stress[i]));
      one["peak_strain"].push_back(json_of(result.peak_strain[i]));
    }
  }
  return json;
}

std::string ends_text(const Sweep& sweep, const std::vector<CaseResult>& results) {
  std::string text;
  for (const CaseResult& result : results)
    text += (text.empty() ? "" : ", ") + result.name + " " +
            output::rounded(1e-6 * result.peak_stress.front().mean) + " to " +
            megapascals(result.peak_stress.back().mean);
  return text + " for " + value_text(sweep, sweep.values.front()) + " to " +
         output::concise(sweep.values.back()) + (sweep.unit.empty() ? "" : " " + sweep.unit);
}

std::string names_where(const std::vector<CaseResult>& results, const std::vector<bool>& holds, bool wanted) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (holds[i] == wanted) names.push_back(results[i].name);
  return names.empty() ? "none" : listed(names, "and");
}

std::vector<Setting> strength_settings(const std::string& property, double mortar_megapascals) {
  return {{"phases.mortar." + property, fmt::format("{:g} MPa", mortar_megapascals)},
          {"phases.itz." + property, fmt::format("{:g} MPa", itz_strength_share * mortar_megapascals)}};
}

}  // namespace app::reproduce
