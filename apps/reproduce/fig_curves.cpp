// Figure 5: normalised stress-strain curves of random specimens, beside those of the design codes.
#include <cmath>

#include "apps/report/key_figures.hpp"
#include "apps/report/reference_curves.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

using output::Ink;

constexpr double shown = 2;   ///< strains over that at the peak that are drawn
constexpr double near = 0.1;  ///< mean distance to a curve of a code that counts as following it
constexpr int places = 201;   ///< on the common axis

/// A curve of a code for the strength that was measured.
struct Reference {
  std::string name;
  std::function<double(double)> curve;  ///< normalised
  double peak_strain = 0;
};

/// The specimens in one direction.
struct Direction {
  std::string name;  ///< of the scene too
  Spread peak_stress, peak_strain;
  double young = 0;  ///< secant modulus at 40 % of the peak [Pa]
  CurveBand band;
  std::vector<Reference> references;
};

std::vector<Trial> curves_trials(const Effort& effort) {
  std::vector<Trial> all;
  for (const char* scene : {"tension", "compression"}) {
    for (int seed = 1; seed <= effort.specimens; ++seed) all.push_back(square_trial(effort, scene, seed));
    all.push_back(square_trial(effort, scene, 1, {{"itz.mode", "points"}}));
  }
  return all;
}

std::vector<Reference> references_of(const Direction& direction) {
  const double strength = direction.peak_stress.mean, young = direction.young;
  if (direction.name == "tension")
    return {{"GB 50010", [=](double x) { return output::gb_tension(x, strength); },
             output::gb_tension_peak_strain(strength)}};
  return {{"GB 50010", [=](double x) { return output::gb_compression(x, strength, young); },
           output::gb_compression_peak_strain(strength)},
          {"EN 1992-1-1", [=](double x) { return output::en_compression(x, strength); },
           output::en_compression_peak_strain(strength)}};
}

Direction direction_of(const Effort& effort, const TrialResults& outcomes, const std::string& name) {
  std::vector<double> stresses, strains, moduli;
  std::vector<Curve> curves;
  for (int seed = 1; seed <= effort.specimens; ++seed) {
    const mpm::Result& result = outcomes.of(square_trial(effort, name, seed)).result;
    stresses.push_back(peak_of(result, &mpm::Result::peak_stress));
    strains.push_back(peak_of(result, &mpm::Result::peak_strain));
    if (!mpm::peak_reached(result)) continue;
    moduli.push_back(output::secant_modulus(result));
    curves.push_back(normalised(result));
  }
  Direction direction{name,
                      spread_of(stresses),
                      spread_of(strains),
                      spread_of(moduli).mean,
                      band_of(curves, even_axis(shown, places)),
                      {}};
  direction.references = references_of(direction);
  return direction;
}

output::Chart chart_of(const Direction& direction) {
  const CurveBand& band = direction.band;
  output::Chart chart{"Normalised curves in " + direction.name,
                      {"Strain over that at the peak", ""},
                      {"Stress over its peak", ""},
                      {},
                      {}};
  chart.series.push_back({"lowest and highest", band.x, band.low, Ink::axis, false});
  chart.series.push_back({"", band.x, band.high, Ink::axis, false});
  Ink ink = Ink::second;
  for (const Reference& reference : direction.references) {
    output::Series series{reference.name, band.x, {}, ink, true};
    for (const double x : band.x) series.y.push_back(reference.curve(x));
    chart.series.push_back(std::move(series));
    ink = Ink::third;
  }
  chart.series.push_back({"mean", band.x, band.mean, Ink::first, false});
  return chart;
}

double distance(const Direction& direction, const Reference& reference, double from, double to) {
  return mean_distance(direction.band, reference.curve, from, to);
}

std::string text_of(const Direction& direction, const Effort& effort) {
  std::string text = "In " + direction.name + " " + counted(effort.specimens, "random specimen") + " bear " +
                     megapascals(direction.peak_stress) + " at " + microstrain(direction.peak_strain) +
                     "; the secant modulus is " + output::rounded(1e-9 * direction.young) + " GPa.";
  for (const Reference& reference : direction.references)
    text += " " + reference.name + " has the peak of such a concrete at " +
            microstrain(reference.peak_strain) + "; the mean curve is off that of the code by " +
            output::rounded(distance(direction, reference, 0, 1), 2) + " of the peak up to the peak and by " +
            output::rounded(distance(direction, reference, 1, shown), 2) + " behind it.";
  return text;
}

/// What the paper's own way of drawing the ITZ changes.
std::string itz_text(const Effort& effort, const TrialResults& outcomes) {
  std::string text =
      "The ITZ is a closed ring of pixels here. With the paper's 36 extra points on each boundary "
      "the first specimen bears ";
  for (const std::string name : {"tension", "compression"}) {
    const double points = peak_of(outcomes.of(square_trial(effort, name, 1, {{"itz.mode", "points"}})).result,
                                  &mpm::Result::peak_stress);
    const double ring = peak_of(outcomes.of(square_trial(effort, name, 1)).result, &mpm::Result::peak_stress);
    text += megapascals(points) + " in place of " + megapascals(ring) + " in " + name +
            (name == "tension" ? " and " : ".");
  }
  return text;
}

/// A stretch of a mean curve beside that of a code.
struct Comparison {
  std::string what;  ///< "tension up to the peak, GB 50010"
  double distance = 0;
  bool falling = false;
};

std::vector<Comparison> comparisons_of(const std::vector<Direction>& directions) {
  std::vector<Comparison> all;
  for (const Direction& direction : directions)
    for (const Reference& reference : direction.references) {
      all.push_back({direction.name + " up to the peak, " + reference.name,
                     distance(direction, reference, 0, 1), false});
      all.push_back(
          {direction.name + " behind it, " + reference.name, distance(direction, reference, 1, shown), true});
    }
  return all;
}

std::string why_of(Verdict verdict, const std::vector<Comparison>& comparisons) {
  std::vector<std::string> holds;
  bool falls_with_the_codes = true;
  for (const Comparison& one : comparisons) {
    if (one.distance <= near) holds.push_back(one.what);
    falls_with_the_codes = falls_with_the_codes && (!one.falling || one.distance <= near);
  }
  const std::string limit = output::percent(near, 0) + " of the peak";
  std::string why = verdict == Verdict::agrees      ? "Every distance is at most " + limit + "."
                    : verdict == Verdict::disagrees ? "No distance is at most " + limit + "."
                                                    : "At most " + limit + ": " + listed(holds, "and") + ".";
  if (!falls_with_the_codes)
    why +=
        " A point that fails loses all its stress at once, so a crack crosses the specimen nearly at the "
        "peak; the "
        "codes describe concrete that softens.";
  return why;
}

Claim claim_of(const std::vector<Direction>& directions) {
  const std::vector<Comparison> comparisons = comparisons_of(directions);
  std::vector<bool> holds;
  std::string measured;
  for (const Comparison& one : comparisons) {
    holds.push_back(one.distance <= near);
    measured += (measured.empty() ? "" : "; ") + one.what + " " + output::rounded(one.distance, 2);
  }
  const Verdict verdict = verdict_of(holds);
  return {"macroscopic-behaviour",
          "5",
          "The model captures the macroscopic behaviour of concrete in tension and in compression.",
          "Mean distance to the curves of the codes, as a share of the peak: " + measured + ".",
          verdict,
          why_of(verdict, comparisons)};
}

nlohmann::json json_of(const Direction& direction) {
  nlohmann::json json{{"peak_stress_Pa", reproduce::json_of(direction.peak_stress)},
                      {"peak_strain", reproduce::json_of(direction.peak_strain)},
                      {"secant_modulus_Pa", direction.young},
                      {"strain_over_peak_strain", direction.band.x},
                      {"mean", direction.band.mean},
                      {"lowest", direction.band.low},
                      {"highest", direction.band.high}};
  for (const Reference& reference : direction.references)
    json["distance"][reference.name] = {{"before_peak", distance(direction, reference, 0, 1)},
                                        {"behind_peak", distance(direction, reference, 1, shown)}};
  return json;
}

Section evaluate_curves(const Effort& effort, const TrialResults& outcomes) {
  const std::vector<Direction> directions{direction_of(effort, outcomes, "tension"),
                                          direction_of(effort, outcomes, "compression")};
  std::string html, charts[2];
  nlohmann::json data;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    html += output::paragraph(text_of(directions[i], effort));
    charts[i] =
        output::chart_figure(chart_of(directions[i]), 480, 360,
                             "In " + directions[i].name +
                                 ": mean of the specimens, the lowest and the "
                                 "highest of them, and the codes for the mean strength. Behind the peak "
                                 "the broken parts ring.");
    data[directions[i].name] = json_of(directions[i]);
  }
  return {html + output::side_by_side("even", charts[0], charts[1]) +
              output::paragraph(itz_text(effort, outcomes)),
          data,
          {claim_of(directions)}};
}

}  // namespace

Figure curves_figure() {
  return {{"5"}, "Curves in tension and in compression", curves_trials, {}, evaluate_curves};
}

}  // namespace app::reproduce
