#include "apps/reproduce/figure.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"

namespace app::reproduce {

std::string word_of(Verdict verdict) {
  using enum Verdict;
  return word_in({{agrees, "agrees"}, {disagrees, "disagrees"}, {depends, "depends"}}, verdict);
}

Verdict verdict_of(const std::vector<bool>& holds) {
  const auto count = std::count(holds.begin(), holds.end(), true);
  if (count == static_cast<std::ptrdiff_t>(holds.size())) return Verdict::agrees;
  return count == 0 ? Verdict::disagrees : Verdict::depends;
}

Verdict verdict_of_share(double share) {
  if (share >= 0.8) return Verdict::agrees;
  return share > 0.2 ? Verdict::depends : Verdict::disagrees;
}

bool in_paper_band(double stress, double strain) {
  const PaperBand band;
  return band.least_stress <= stress && stress <= band.largest_stress && band.least_strain <= strain &&
         strain <= band.largest_strain;
}

Trial square_trial(const Effort& effort, const std::string& scene, int seed,
                   const std::vector<Setting>& settings, bool keep_maps) {
  const std::string number = std::to_string(seed);
  Trial trial{scene, {{"generate.seed", number}, {"damage.seed", number}}, keep_maps};
  for (const auto* more : {&settings, &effort.square})
    trial.settings.insert(trial.settings.end(), more->begin(), more->end());
  return trial;
}

namespace {

std::string with_deviation(const Spread& spread, double factor, const std::string& unit) {
  std::string text = output::rounded(factor * spread.mean);
  if (spread.deviation > 0) text += " ± " + output::rounded(factor * spread.deviation, 2);
  return text + " " + unit;
}

}  // namespace

std::string megapascals(double stress) { return output::rounded(1e-6 * stress) + " MPa"; }
std::string microstrain(double strain) { return output::rounded(1e6 * strain) + " microstrain"; }
std::string megapascals(const Spread& stress) { return with_deviation(stress, 1e-6, "MPa"); }
std::string microstrain(const Spread& strain) { return with_deviation(strain, 1e6, "microstrain"); }

std::string counted(int count, const std::string& noun) {
  return count == 1 ? "one " + noun : std::to_string(count) + " " + noun + "s";
}

nlohmann::json json_of(const Spread& spread) {
  return {{"mean", spread.mean},
          {"standard_deviation", spread.deviation},
          {"least", spread.low},
          {"largest", spread.high}};
}

std::string damage_legend(const specimen::LabelledMask& mask) {
  return output::legend("", output::damage_entries(mask, output::colour_palette()));
}

std::string damage_pictures(const TrialResult& outcome, const std::vector<int>& percents,
                            const std::string& caption) {
  std::string html;
  for (const output::DamageStage& stage : output::damage_stages(outcome.result).drawn) {
    if (std::find(percents.begin(), percents.end(), stage.percent) == percents.end()) continue;
    const std::string share =
        fmt::format("{} % of {}", stage.percent, output::reference_strain(outcome.result));
    html +=
        "<figure>\n" +
        output::image(output::damage_picture(outcome.specimen.mask, outcome.result, stage.strain,
                                             output::colour_palette()),
                      "Damage at " + share, "") +
        fmt::format(
            "<figcaption><b>{}</b>{}<br/>{}<br/>{} failed in tension, {} in shear</figcaption>\n</figure>\n",
            share, output::escape(caption), microstrain(stage.strain), output::grouped(stage.tension),
            output::grouped(stage.shear));
  }
  return html;
}

}  // namespace app::reproduce
