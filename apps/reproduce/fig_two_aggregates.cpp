// Figures 8 to 11: two aggregates in tension, with the strengths of Table 1 and calibrated ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/reproduce/crack_place.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

using output::Ink;

constexpr PaperBand band;
constexpr double itz_share = 0.6;  ///< strength of the ITZ over that of the mortar, Table 1
constexpr int shown_fields = 2;    ///< whose damage is drawn

/// One strength field.
Trial trial_of(const Effort& effort, int seed, double scale) {
  Trial trial{"two_aggregates", {{"damage.seed", std::to_string(seed)}}, true};
  if (scale > 0) {
    trial.settings.emplace_back("phases.mortar.tensile_scale", fmt::format("{:.2f} MPa", 1e-6 * scale));
    trial.settings.emplace_back("phases.itz.tensile_scale",
                                fmt::format("{:.2f} MPa", 1e-6 * itz_share * scale));
  }
  trial.settings.insert(trial.settings.end(), effort.pair.begin(), effort.pair.end());
  return trial;
}

/// All fields; scale 0 = that of Table 1.
std::vector<Trial> fields(const Effort& effort, double scale) {
  std::vector<Trial> all;
  for (int seed = 1; seed <= effort.specimens; ++seed) all.push_back(trial_of(effort, seed, scale));
  return all;
}

/// What all fields gave.
struct Sample {
  std::string name;
  double scale = 0;  ///< f_t of the mortar [Pa]
  std::vector<double> stresses, strains;
  std::vector<const TrialResult*> outcomes;
};

Sample sample_of(const std::string& name, const std::vector<Trial>& trials, const TrialResults& outcomes) {
  Sample sample{name, 0, {}, {}, {}};
  for (const mpm::Phase& phase : settings_of(trials.front()).phases)
    if (phase.name == "mortar") sample.scale = phase.tensile_scale;
  for (const Trial& trial : trials) {
    sample.outcomes.push_back(&outcomes.of(trial));
    sample.stresses.push_back(peak_of(sample.outcomes.back()->result, &mpm::Result::peak_stress));
    sample.strains.push_back(peak_of(sample.outcomes.back()->result, &mpm::Result::peak_strain));
  }
  return sample;
}

/// Stresses go with the strengths, so one step leads to the middle of the paper's peaks; to 0.1 MPa.
double calibrated_scale(const Sample& table1) {
  const double wanted = (band.least_stress + band.largest_stress) / 2;
  return std::round(table1.scale * wanted / spread_of(table1.stresses).mean / 1e5) * 1e5;
}

std::vector<Trial> table1_trials(const Effort& effort) { return fields(effort, 0); }

std::vector<Trial> calibrated_trials(const Effort& effort, const TrialResults& outcomes) {
  return fields(effort, calibrated_scale(sample_of("Table 1", table1_trials(effort), outcomes)));
}

/// Whether the mean peak lies where the paper's peaks lie.
bool in_band(const Sample& sample) {
  return in_paper_band(spread_of(sample.stresses).mean, spread_of(sample.strains).mean);
}

std::string peaks_text(const Sample& sample) {
  return megapascals(spread_of(sample.stresses)) + " at " + microstrain(spread_of(sample.strains)) +
         " (f_t = " + megapascals(sample.scale) + ")";
}

Claim peak_claim(const Sample& table1, const Sample& calibrated) {
  Claim claim{"two-aggregates-peak",
              "10",
              "The peak is 1.40 to 2.09 MPa at 45.92 to 103.21 microstrain.",
              "Table 1: " + peaks_text(table1) + "; calibrated: " + peaks_text(calibrated) + ".",
              Verdict::disagrees,
              ""};
  if (in_band(table1)) {
    claim.verdict = Verdict::agrees;
    claim.why = "The strengths of Table 1 give it as they stand.";
  } else if (in_band(calibrated)) {
    claim.verdict = Verdict::depends;
    claim.why = "The strengths of Table 1 do not give it; f_t = " + megapascals(calibrated.scale) +
                " in the mortar does, with the ITZ at " + output::concise(itz_share) + " of it.";
  } else {
    claim.why = "Neither Table 1 nor strengths that were calibrated for the peak stress give it.";
  }
  return claim;
}

/// How often the crack runs where.
struct Crack {
  int tops = 0, bottoms = 0, other = 0;
  int above = 0, below = 0;  ///< of the centres of both aggregates
  double share =
      0;  ///< of the late failures across the specimen in a band of crack_band, mean over the fields

  [[nodiscard]] int fields() const { return tops + bottoms + other; }
};

Crack cracks_of(const Sample& sample) {
  Crack crack;
  for (const TrialResult* outcome : sample.outcomes) {
    const specimen::LabelledMask& mask = outcome->specimen.mask;
    bool all_top = true, all_bottom = true, all_above = true, all_below = true;
    for (const specimen::Inclusion& inclusion : outcome->specimen.inclusions) {
      const CrackBeside beside = crack_beside(mask, outcome->result, inclusion.ellipse);
      all_top = all_top && beside.side == CrackSide::top;
      all_bottom = all_bottom && beside.side == CrackSide::bottom;
      all_above = all_above && beside.height > inclusion.ellipse.y;
      all_below = all_below && beside.height < inclusion.ellipse.y;
    }
    ++(all_top ? crack.tops : all_bottom ? crack.bottoms : crack.other);
    crack.above += all_above;
    crack.below += all_below;
    crack.share += crack_between(mask, outcome->result, 0, mask.width()).share /
                   static_cast<double>(sample.outcomes.size());
  }
  return crack;
}

std::string crack_text(const Crack& crack) {
  return fmt::format(
      "near the tops of both aggregates in {} of {} fields, near both bottoms in {}, elsewhere in {}",
      crack.tops, crack.fields(), crack.bottoms, crack.other);
}

std::string height_text(const Crack& crack) {
  return fmt::format("it passes above the centres of both in {} fields and below them in {}", crack.above,
                     crack.below);
}

Claim crack_claim(const Crack& crack) {
  Claim claim{"two-aggregates-crack",
              "11",
              "One localised crack forms near the tops of the two aggregates.",
              "The crack runs " + crack_text(crack) + "; " + height_text(crack) + ".",
              verdict_of_share(static_cast<double>(crack.tops) / crack.fields()),
              ""};
  switch (claim.verdict) {
    case Verdict::agrees:
      claim.why = "At least 80 % of the random fields crack there.";
      break;
    case Verdict::depends:
      claim.why = "It is the random field that decides: between 20 and 80 % of the fields crack there.";
      break;
    case Verdict::disagrees:
      claim.why = "At most 20 % of the fields crack there; it is the random field that decides where.";
  }
  return claim;
}

output::Chart chart_of(const Sample& sample) {
  output::Chart chart{"Curves of two aggregates", {"Strain", "microstrain"}, {"Stress", "MPa"}, {}, {}};
  for (std::size_t i = 0; i < sample.outcomes.size(); ++i) {
    const std::string name = i == 0 ? "field 1" : i == 1 ? "the others" : "";
    chart.series.push_back(
        output::stress_series(name, i == 0 ? Ink::first : Ink::axis, sample.outcomes[i]->result));
  }
  std::reverse(chart.series.begin(), chart.series.end());  // the first field on top
  return chart;
}

std::vector<std::string> row_of(const Sample& sample) {
  const Crack crack = cracks_of(sample);
  return {
      sample.name + ", f_t = " + megapascals(sample.scale),
      megapascals(spread_of(sample.stresses)),
      output::percent(share_within(finite_of(sample.stresses), band.least_stress, band.largest_stress), 0),
      microstrain(spread_of(sample.strains)),
      output::percent(share_within(finite_of(sample.strains), band.least_strain, band.largest_strain), 0),
      std::to_string(crack.tops),
      std::to_string(crack.bottoms),
      std::to_string(crack.other)};
}

nlohmann::json json_of(const Sample& sample) {
  const Crack crack = cracks_of(sample);
  return {{"tensile_scale_Pa", sample.scale},
          {"peak_stress_Pa", reproduce::json_of(spread_of(sample.stresses))},
          {"peak_strain", reproduce::json_of(spread_of(sample.strains))},
          {"crack_near_tops", crack.tops},
          {"crack_near_bottoms", crack.bottoms},
          {"crack_elsewhere", crack.other},
          {"crack_above_centres", crack.above},
          {"crack_below_centres", crack.below},
          {"share_of_late_failures_in_band", crack.share}};
}

std::string definition(const Crack& crack) {
  return fmt::format(
      "The crack is where points fail between the peak strain and 150 % of it. Over the width of each "
      "aggregate it "
      "is the band of {} mm that holds the most of these failures; it is near the top, or the bottom, of the "
      "aggregate when the mean height of the failures in the band is within {} mm of it. Across the whole "
      "specimen "
      "one such band holds {} of them, as a mean over the fields.",
      output::concise(1e3 * crack_band), output::concise(1e3 * crack_band), output::percent(crack.share, 0));
}

Section evaluate_two_aggregates(const Effort& effort, const TrialResults& outcomes) {
  const Sample table1 = sample_of("Table 1", table1_trials(effort), outcomes);
  const Sample calibrated = sample_of("Calibrated", calibrated_trials(effort, outcomes), outcomes);
  const Crack crack = cracks_of(calibrated);
  const std::string text = "With Table 1 the specimen bears " + peaks_text(table1) +
                           "; the paper's peaks are lower. As stresses go with "
                           "the strengths, the scale that leads to the middle of the paper's peaks follows "
                           "at once; with it the specimen "
                           "bears " +
                           peaks_text(calibrated) + ". The crack runs " + crack_text(crack) + ".";
  std::string pictures;
  for (int field = 0; field < std::min(shown_fields, effort.specimens); ++field)
    pictures += damage_pictures(*calibrated.outcomes[static_cast<std::size_t>(field)], {75, 100, 150},
                                ", field " + std::to_string(field + 1));
  return {output::paragraph(text) +
              output::chart_figure(chart_of(calibrated), 640, 360,
                                   "With the calibrated strengths. Behind the peak the broken parts ring.") +
              output::number_table({"Strengths", "Peak stress", "in band", "Peak strain", "in band", "Tops",
                                    "Bottoms", "Elsewhere"},
                                   {row_of(table1), row_of(calibrated)}) +
              output::remarks(output::paragraph(definition(crack))) +
              damage_legend(calibrated.outcomes.front()->specimen.mask) + output::pictures(pictures),
          {{"table_1", json_of(table1)}, {"calibrated", json_of(calibrated)}},
          {peak_claim(table1, calibrated), crack_claim(crack)}};
}

}  // namespace

Figure two_aggregates_figure() {
  return {{"8", "9", "10", "11"},
          "Two aggregates in tension",
          table1_trials,
          calibrated_trials,
          evaluate_two_aggregates};
}

}  // namespace app::reproduce
