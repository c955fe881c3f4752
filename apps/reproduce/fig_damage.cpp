// Figures 6 and 7: how the damage grows in tension and in compression.
#include "apps/drawing/damage_picture.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

const std::vector<int> percents(output::stage_percents.begin(), output::stage_percents.end());

Trial trial_of(const Effort& effort, const std::string& scene) {
  return square_trial(effort, scene, 1, {}, true);
}

std::vector<Trial> damage_trials(const Effort& effort) {
  return {trial_of(effort, "tension"), trial_of(effort, "compression")};
}

/// Share of the failures up to a stage that were in tension [-]; NaN where nothing failed.
double tension_share(const output::DamageStage& stage) {
  const auto all = static_cast<double>(stage.tension + stage.shear);
  return static_cast<double>(stage.tension) / all;
}

std::string stage_text(const output::DamageStages& stages, const output::DamageStage& stage) {
  return std::to_string(stage.percent) + " % of " + stages.of;
}

Claim claim_of(const output::DamageStages& stages) {
  std::vector<bool> holds;
  std::string measured;
  for (const output::DamageStage& stage : stages.drawn) {
    if (stage.percent < 100) continue;
    const double share = tension_share(stage);
    holds.push_back(share > 0.5);
    measured += (measured.empty() ? "" : ", ") + output::percent(share) + " at " + stage_text(stages, stage);
  }
  if (holds.empty()) holds.push_back(false);
  Claim claim{"compression-damage-in-tension",
              "7",
              "Damage in compression is mostly of the tension type.",
              "Failures that were in tension: " + measured + ".",
              verdict_of(holds),
              ""};
  claim.why =
      claim.verdict == Verdict::agrees
          ? "More than half of the points fail in tension, from the peak on. Without crack closure a point "
            "that has cracked carries nothing, so that it can no longer be crushed."
          : "At some stage from the peak on, half of the points or more have failed in shear.";
  return claim;
}

std::string text_of(const output::DamageStages& stages, const std::string& name) {
  if (stages.drawn.empty()) return "In " + name + " no stress rose above 0.";
  const output::DamageStage& last = stages.drawn.back();
  std::string text = "In " + name + " " + output::grouped(last.tension + last.shear) +
                     " points have failed at " + stage_text(stages, last) + ", " +
                     output::percent(tension_share(last)) + " of them in tension";
  for (const output::DamageStage& stage : stages.drawn)
    if (stage.percent == 100 && stages.of_peak)
      text += "; " +
              output::percent(static_cast<double>(stage.tension + stage.shear) /
                              static_cast<double>(last.tension + last.shear)) +
              " of these failures came up to the peak";
  return text + ".";
}

nlohmann::json json_of(const output::DamageStages& stages) {
  nlohmann::json json = nlohmann::json::array();
  for (const output::DamageStage& stage : stages.drawn)
    json.push_back({{"percent_of_peak_strain", stages.of_peak ? nlohmann::json(stage.percent) : nullptr},
                    {"strain", stage.strain},
                    {"tension_failures", stage.tension},
                    {"shear_failures", stage.shear}});
  return json;
}

Section evaluate_damage(const Effort& effort, const TrialResults& outcomes) {
  Section section;
  for (const std::string name : {"tension", "compression"}) {
    const TrialResult& outcome = outcomes.of(trial_of(effort, name));
    const output::DamageStages stages = output::damage_stages(outcome.result);
    section.html += "<h3>" + std::string(name == "tension" ? "Figure 6. Tension" : "Figure 7. Compression") +
                    "</h3>\n" + output::paragraph(text_of(stages, name)) +
                    damage_legend(outcome.specimen.mask) +
                    output::pictures(damage_pictures(outcome, percents));
    section.data[name] = json_of(stages);
    if (name == "compression") section.claims.push_back(claim_of(stages));
  }
  return section;
}

}  // namespace

Figure damage_figure() { return {{"6", "7"}, "Damage", damage_trials, {}, evaluate_damage}; }

}  // namespace app::reproduce
