// Figure 3: density and distribution of the strengths, measured on the points of a specimen.
#include <cmath>

#include "apps/job/job.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/statistics/weibull_fit.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"
#include "libmpm/material/strength.hpp"

namespace app::reproduce {
namespace {

using output::Ink;

constexpr int bins = 40;
constexpr double shown_scales = 3;  ///< strengths up to so many times the scale are drawn

/// The tensile strengths of the points of a phase.
struct Strengths {
  mpm::Phase phase;
  std::vector<double> values;  ///< [Pa]
  double distance = 0;         ///< Kolmogorov-Smirnov
  double critical = 0;
};

Strengths strengths_of(const mpm::Scene& scene, std::uint8_t label) {
  Strengths strengths{*scene.phases[label], {}, 0, 0};
  const auto rows = static_cast<int>(scene.labels.rows()), cols = static_cast<int>(scene.labels.cols());
  for (int row = 0; row < rows; ++row)
    for (int col = 0; col < cols; ++col)
      if (scene.labels(row, col) == label)
        strengths.values.push_back(mpm::tension_threshold(
            strengths.phase, mpm::strength_factor(mpm::pixel_random(scene.damage.seed, row, col),
                                                  strengths.phase.weibull_modulus)));
  const mpm::Phase& phase = strengths.phase;
  strengths.distance = largest_distance(strengths.values, [&](double strength) {
    return weibull_distribution(strength, phase.tensile_scale, phase.weibull_modulus);
  });
  strengths.critical = critical_distance(strengths.values.size());
  return strengths;
}

std::vector<Strengths> measure(const Effort& effort) {
  const mpm::Scene scene = make_job(settings_of(square_trial(effort, "tension", 1))).scene;
  std::vector<Strengths> all;
  for (std::size_t label = 0; label < scene.phases.size(); ++label)
    if (scene.phases[label] && scene.phases[label]->can_crack())
      all.push_back(strengths_of(scene, static_cast<std::uint8_t>(label)));
  return all;
}

/// Axis of strengths over their scale; not from 0, where the density of m < 1 has no end.
std::vector<double> fine_axis() {
  std::vector<double> axis = even_axis(shown_scales, 301);
  axis.front() = 1e-6;
  return axis;
}

output::Series steps(const Strengths& strengths) {
  const double end = shown_scales * strengths.phase.tensile_scale, width = shown_scales / bins;
  output::Series series{"measured", {}, {}, Ink::first, false};
  const std::vector<double> density = histogram(strengths.values, end, bins);
  for (std::size_t bin = 0; bin < density.size(); ++bin)
    for (const std::size_t side : {bin, bin + 1}) {
      series.x.push_back(width * static_cast<double>(side));
      series.y.push_back(density[bin] * strengths.phase.tensile_scale);
    }
  return series;
}

output::Chart density_chart(const Strengths& strengths) {
  output::Series formula{"Weibull", fine_axis(), {}, Ink::second, false};
  for (const double x : formula.x)
    formula.y.push_back(weibull_density(x, 1, strengths.phase.weibull_modulus));
  return {"Density of the strengths",
          {"Strength over its scale", ""},
          {"Density", ""},
          {steps(strengths), formula},
          {}};
}

output::Chart distribution_chart(const Strengths& strengths) {
  output::Series measured{"measured", fine_axis(), {}, Ink::first, false};
  output::Series formula{"Weibull", measured.x, {}, Ink::second, true};
  for (const double x : measured.x) {
    measured.y.push_back(share_within(strengths.values, 0, x * strengths.phase.tensile_scale));
    formula.y.push_back(weibull_distribution(x, 1, strengths.phase.weibull_modulus));
  }
  return {"Distribution of the strengths",
          {"Strength over its scale", ""},
          {"Share of weaker points", ""},
          {measured, formula},
          {}};
}

Claim claim_of(const std::vector<Strengths>& all) {
  std::vector<bool> holds;
  std::string measured;
  for (const Strengths& one : all) {
    holds.push_back(one.distance <= one.critical);
    measured += (measured.empty() ? "" : "; ") + output::phase_word(one.phase.name) + " " +
                output::rounded(one.distance, 2) + " (critical " + output::rounded(one.critical, 2) + ")";
  }
  Claim claim{"weibull-strengths",
              "3",
              "The strengths of the points follow a Weibull distribution.",
              "Kolmogorov-Smirnov distance: " + measured + ".",
              verdict_of(holds),
              ""};
  claim.why = claim.verdict == Verdict::agrees
                  ? "Each distance is under the value that one sample in twenty exceeds by chance."
                  : "Not every distance is under the value that one sample in twenty exceeds by chance.";
  return claim;
}

std::vector<std::string> row_of(const Strengths& one) {
  const double expected = one.phase.tensile_scale * std::tgamma(1 + 1 / one.phase.weibull_modulus);
  return {output::capitalised(output::phase_word(one.phase.name)),
          output::grouped(static_cast<std::int64_t>(one.values.size())),
          output::rounded(1e-6 * spread_of(one.values).mean),
          output::rounded(1e-6 * expected),
          output::rounded(one.distance, 2),
          output::rounded(one.critical, 2)};
}

Section evaluate_weibull(const Effort& effort, const TrialResults&) {
  const std::vector<Strengths> all = measure(effort);
  std::vector<std::vector<std::string>> rows;
  nlohmann::json data;
  for (const Strengths& one : all) {
    rows.push_back(row_of(one));
    data[one.phase.name] = {{"points", one.values.size()},
                            {"mean_Pa", spread_of(one.values).mean},
                            {"distance", one.distance},
                            {"critical_distance", one.critical}};
  }
  const Strengths& shown = all.front();
  const std::string text =
      "Every point of mortar and ITZ draws one number, which sets its strength in tension and in shear. The "
      "curves "
      "show the tensile strengths of the " +
      output::grouped(static_cast<std::int64_t>(shown.values.size())) + " points of " + shown.phase.name +
      " of one specimen, over the scale f_t of " + megapascals(shown.phase.tensile_scale) +
      "; m = " + output::concise(shown.phase.weibull_modulus) + ".";
  return {
      output::paragraph(text) +
          output::side_by_side("even", output::chart_figure(density_chart(shown), 480, 330, "Density"),
                               output::chart_figure(distribution_chart(shown), 480, 330, "Distribution")) +
          output::number_table(
              {"Phase", "Points", "Mean MPa", "f_t Γ(1 + 1/m)", "Distance", "Critical at 5 %"}, rows),
      data,
      {claim_of(all)}};
}

}  // namespace

Figure weibull_figure() {
  return {
      {"3"}, "Random strengths", [](const Effort&) { return std::vector<Trial>(); }, {}, evaluate_weibull};
}

}  // namespace app::reproduce
