// Figures 12 to 14: the Weibull modulus m, the scale f_t of the tensile strength, and the cohesion c.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/report_parts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/reproduce/sweep.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

/// Rank correlation that counts as a rise or a fall; of five values two neighbours may change places (0.9).
constexpr double clear_trend = 0.85;
constexpr const char* trend_counts = " A trend counts from a rank correlation of 0.85 on.";
constexpr double moves = 0.05;  ///< change of a peak between the ends of a sweep that counts as one
constexpr double half = 0.5;    ///< exponent from which on a peak goes with a strength

const Case tension{"tension", "tension", {}, 0};
const Case compression{"compression", "compression", {}, 0};
/// One specimen: cracks that close make long runs.
const Case unilateral{"compression, cracks close (unilateral)", "compression_closure", {}, 1};
const Case clipped{
    "compression, cracks close (clipped)", "compression_closure", {{"damage.crack_closure", "clipped"}}, 1};

Sweep modulus_sweep() {
  const auto settings = [](double m) {
    return std::vector<Setting>{{"phases.mortar.weibull_modulus", fmt::format("{:g}", m)},
                                {"phases.itz.weibull_modulus", fmt::format("{:g}", m)}};
  };
  return {"m", "", {1, 1.5, 2, 3, 6}, 1.5, settings, {tension, compression}};
}

Sweep strength_sweep() {
  const auto settings = [](double f) { return strength_settings("tensile_scale", f); };
  return {"f_t", "MPa", {5, 10, 15, 20, 25}, 15, settings, {tension, compression}};
}

Sweep cohesion_sweep() {
  const auto settings = [](double c) { return strength_settings("cohesion", c); };
  return {"c", "MPa", {110, 130, 150, 170, 190}, 150, settings, {tension, compression, clipped, unilateral}};
}

/// "holds in tension, not in compression".
std::string where(const std::vector<CaseResult>& results, const std::vector<bool>& holds) {
  return "Holds in: " + names_where(results, holds, true) +
         "; does not hold in: " + names_where(results, holds, false) + ".";
}

Claim rise_claim(const Sweep& sweep, const std::vector<CaseResult>& results) {
  std::vector<bool> holds;
  for (const CaseResult& result : results)
    holds.push_back(rank_correlation(result.values, result.mean_stress()) >= clear_trend);
  Claim claim{"peaks-rise-with-m",      "12",
              "The peaks rise with m.", "Peaks: " + ends_text(sweep, results) + ".",
              verdict_of(holds),        ""};
  claim.why = claim.verdict == Verdict::agrees
                  ? "Less scatter leaves fewer weak points, from which cracks start."
                  : where(results, holds);
  claim.why += trend_counts;
  return claim;
}

Claim brittle_claim(const std::vector<CaseResult>& results) {
  std::vector<bool> holds;
  std::string measured;
  for (const CaseResult& result : results) {
    holds.push_back(rank_correlation(result.values, result.drop) <= -clear_trend);
    measured += (measured.empty() ? "" : "; ") + result.name;
    for (const double drop : result.drop) measured += " " + output::rounded(drop);
  }
  Claim claim{"more-brittle-with-m",
              "12",
              "The curve gets more brittle with m.",
              "Strain at which half the peak is lost over that at the peak, m rising: " + measured + ".",
              verdict_of(holds),
              ""};
  claim.why = claim.verdict == Verdict::agrees
                  ? "The points fail at nearly the same stress, and so at once. The drop is steep at every m."
                  : where(results, holds) + " The drop is steep at every m, which leaves little to see.";
  claim.why += trend_counts;
  return claim;
}

Claim strength_claim(const Sweep& sweep, const std::vector<CaseResult>& results) {
  std::vector<bool> holds;
  std::string powers;
  for (const CaseResult& result : results) {
    const double power = power_of(result.values, result.mean_stress());
    holds.push_back(power >= half);
    powers += (powers.empty() ? "" : ", ") + result.name + " " + output::rounded(power, 2);
  }
  Claim claim{"strength-moves-both-peaks",
              "13",
              "f_t moves the peaks in tension and in compression.",
              "Peaks: " + ends_text(sweep, results) + ". They go with f_t to the power of: " + powers + ".",
              verdict_of(holds),
              ""};
  claim.why = claim.verdict == Verdict::agrees
                  ? "Points fail in tension in both tests, across the load or along it."
                  : where(results, holds);
  claim.why += " A peak counts as moved from a power of 0.5 on.";
  return claim;
}

/// Change of the peak between the ends of a sweep, over the first one [-].
double change_of(const CaseResult& result) {
  return result.peak_stress.back().mean / result.peak_stress.front().mean - 1;
}

/// Whether the cohesion moves the peak of a compression test, and more than that in tension.
bool moved_more(const CaseResult& result, const CaseResult& in_tension) {
  return change_of(result) > moves && change_of(result) > 2 * std::abs(change_of(in_tension));
}

Claim cohesion_claim(const Sweep& sweep, const std::vector<CaseResult>& results) {
  std::vector<bool> holds;
  const std::vector<CaseResult> tests(results.begin() + 1, results.end());
  for (const CaseResult& test : tests) holds.push_back(moved_more(test, results.front()));
  Claim claim{"cohesion-moves-compression",
              "14",
              "c moves mainly the peak in compression.",
              "Peaks: " + ends_text(sweep, results) + ".",
              verdict_of(holds),
              ""};
  claim.why =
      claim.verdict == Verdict::agrees
          ? "The peak in compression changes by more than 5 %, and by more than twice as much as in tension."
          : where(tests, holds) +
                " Where a cracked point carries nothing, it cannot be crushed, and few others fail in shear.";
  return claim;
}

/// Largest imbalance of the ledger of the runs of the first specimen, over the work [-].
double energy_error(const CaseResult& result) {
  double largest = 0;
  for (const mpm::Result* run : result.first) largest = std::max(largest, run->energy_error);
  return largest;
}

std::string cohesion_text(const std::vector<CaseResult>& results) {
  std::string text = "From the lowest to the highest c the peak changes";
  for (std::size_t i = 0; i < results.size(); ++i)
    text += (i == 0 ? " by " : ", by ") + output::percent(change_of(results[i])) + " in " + results[i].name;
  text += ". The ledger of energies misses at most";
  for (std::size_t i = 0; i < results.size(); ++i)
    text += (i == 0 ? " " : ", ") + output::rounded(100 * energy_error(results[i]), 2) + " %";
  return text +
         " of the work in them; clipping the stress of a closed crack does not keep energy, the unilateral "
         "law does.";
}

Section section_of(const Sweep& sweep, const std::vector<CaseResult>& results, const std::string& text,
                   std::vector<Claim> claims) {
  return {output::paragraph(text) + sweep_html(sweep, results), sweep_json(results), std::move(claims)};
}

Section evaluate_modulus(const Effort& effort, const TrialResults& outcomes) {
  const Sweep sweep = modulus_sweep();
  const auto results = results_of(sweep, effort, outcomes);
  return section_of(sweep, results,
                    "Mortar and ITZ have the same m. Peaks: " + ends_text(sweep, results) + ".",
                    {rise_claim(sweep, results), brittle_claim(results)});
}

Section evaluate_strength(const Effort& effort, const TrialResults& outcomes) {
  const Sweep sweep = strength_sweep();
  const auto results = results_of(sweep, effort, outcomes);
  return section_of(
      sweep, results,
      "f_t is that of the mortar; the ITZ keeps 0.6 of it. Peaks: " + ends_text(sweep, results) + ".",
      {strength_claim(sweep, results)});
}

Section evaluate_cohesion(const Effort& effort, const TrialResults& outcomes) {
  const Sweep sweep = cohesion_sweep();
  const auto results = results_of(sweep, effort, outcomes);
  return section_of(sweep, results,
                    "c is that of the mortar; the ITZ keeps 0.6 of it. " + cohesion_text(results),
                    {cohesion_claim(sweep, results)});
}

template <Sweep (*sweep)()>
std::vector<Trial> trials(const Effort& effort) {
  return trials_of(sweep(), effort);
}

}  // namespace

Figure modulus_figure() {
  return {{"12"}, "The Weibull modulus", trials<modulus_sweep>, {}, evaluate_modulus};
}
Figure strength_figure() {
  return {{"13"}, "The tensile strength", trials<strength_sweep>, {}, evaluate_strength};
}
Figure cohesion_figure() { return {{"14"}, "The cohesion", trials<cohesion_sweep>, {}, evaluate_cohesion}; }

}  // namespace app::reproduce
