// Beyond the paper: what the size of the pixels does to the peak and to the energy that a crack takes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

constexpr int most_fields = 5;
constexpr double converged = 0.03;  ///< change of a mean between the two finest pictures that counts as none

struct Law {
  std::string name;
  std::vector<Setting> settings;
};

const std::vector<Law>& laws() {
  static const std::vector<Law> both{
      {"at one blow",
       {{"phases.mortar.fracture_energy", "brittle"}, {"phases.itz.fracture_energy", "brittle"}}},
      {"crack band", {}}};
  return both;
}

int fields_of(const Effort& effort) { return std::min(most_fields, effort.specimens); }

/// Not a square_trial: the specimen is one, its fields and its pixels differ.
Trial trial_of(const Law& law, double pixel_size, int field) {
  Trial trial{"objectivity", law.settings, false};
  trial.settings.emplace_back("generate.pixel_size", fmt::format("{:g} mm", pixel_size));
  trial.settings.emplace_back("damage.seed", std::to_string(field));
  return trial;
}

std::vector<Trial> objectivity_trials(const Effort& effort) {
  std::vector<Trial> trials;
  for (const Law& law : laws())
    for (const double size : effort.pixel_sizes)
      for (int field = 1; field <= fields_of(effort); ++field) trials.push_back(trial_of(law, size, field));
  return trials;
}

/// Of one law, pixel size by pixel size.
struct Convergence {
  std::string law;
  std::vector<double> pixel_sizes;        ///< [mm]
  std::vector<Spread> peak;               ///< [Pa]
  std::vector<Spread> released;           ///< by the end of the run [J/m]
  std::vector<const mpm::Result*> first;  ///< of the first field

  /// Change of a mean between the two finest pictures [-].
  [[nodiscard]] static double change(const std::vector<Spread>& means) {
    return means.back().mean / means[means.size() - 2].mean - 1;
  }
};

Convergence convergence_of(const Law& law, const Effort& effort, const TrialResults& outcomes) {
  Convergence convergence{law.name, effort.pixel_sizes, {}, {}, {}};
  for (const double size : effort.pixel_sizes) {
    std::vector<double> peaks, energies;
    for (int field = 1; field <= fields_of(effort); ++field) {
      const mpm::Result& run = outcomes.of(trial_of(law, size, field)).result;
      peaks.push_back(peak_of(run, &mpm::Result::peak_stress));
      energies.push_back(run.history.empty() ? 0 : run.history.back().released);
      if (field == 1) convergence.first.push_back(&run);
    }
    convergence.peak.push_back(spread_of(peaks));
    convergence.released.push_back(spread_of(energies));
  }
  return convergence;
}

/// Means against the size of the pixels, finest first.
output::Chart means_chart(const std::string& title, const output::Axis& axis, double unit,
                          const std::vector<Convergence>& all, std::vector<Spread> Convergence::*quantity) {
  output::Chart chart{title, {"Pixel size", "mm"}, axis, {}, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    output::Series series{all[i].law, {}, {}, output::ink_of_series(i), false};
    for (std::size_t k = all[i].pixel_sizes.size(); k-- > 0;) {
      series.x.push_back(all[i].pixel_sizes[k]);
      series.y.push_back((all[i].*quantity)[k].mean / unit);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

output::Chart curves_chart(const Convergence& convergence) {
  output::Chart chart{"Curves, " + convergence.law, {"Strain", "microstrain"}, {"Stress", "MPa"}, {}, {}};
  for (std::size_t k = 0; k < convergence.pixel_sizes.size(); ++k)
    chart.series.push_back(output::stress_series(fmt::format("{:g} mm", convergence.pixel_sizes[k]),
                                                 output::ink_of_series(k), *convergence.first[k]));
  return chart;
}

std::string plus_minus(const Spread& spread, double unit) {
  return output::rounded(spread.mean / unit) + " ± " + output::rounded(spread.deviation / unit, 1);
}

std::string table_of(const Convergence& convergence) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < convergence.pixel_sizes.size(); ++k)
    rows.push_back({fmt::format("{:g} mm", convergence.pixel_sizes[k]), plus_minus(convergence.peak[k], 1e6),
                    plus_minus(convergence.released[k], 1)});
  return output::number_table({"Pixel", "Peak MPa", "Energy J/m"}, rows);
}

std::string half_html(const Convergence& convergence) {
  return "<h3>Points crack " +
         std::string(convergence.law == "crack band" ? "in a crack band" : "at one blow") + "</h3>\n" +
         output::chart_figure(curves_chart(convergence), 480, 350, "Curves of the first field.") +
         table_of(convergence);
}

/// "the mean peak changes by -2.1 % and the energy by 0.4 %".
std::string changes_text(const Convergence& convergence) {
  return "the mean peak changes by " + output::percent(Convergence::change(convergence.peak)) +
         " and the energy by " + output::percent(Convergence::change(convergence.released));
}

std::string verdict_text(const Convergence& band) {
  const auto settled = [](double change) { return std::abs(change) <= converged; };
  const bool peak = settled(Convergence::change(band.peak));
  const bool energy = settled(Convergence::change(band.released));
  if (peak && energy) return "Both are within 3 %: with a crack band they no longer depend on the pixel.";
  if (peak)
    return "The peak no longer depends on the pixel; the energy does still, for where the cracks run differs "
           "from picture to picture.";
  return "The peak still depends on the pixel: the pictures are too coarse for this field, or for these "
         "aggregates.";
}

std::string text_of(const Effort& effort, const std::vector<Convergence>& all) {
  return "One specimen, " + counted(fields_of(effort), "field") +
         " of strengths with a correlation length, drawn alike at every pixel size; energy is what all "
         "cracks "
         "have taken by the end of the run. From the second finest picture to the finest, " +
         changes_text(all[0]) + " where points crack at one blow, as in the paper; with a crack band " +
         changes_text(all[1]) + ". " + verdict_text(all[1]);
}

nlohmann::json json_of_all(const std::vector<Convergence>& all) {
  nlohmann::json json;
  for (const Convergence& one : all) {
    nlohmann::json& law = json[one.law];
    law["peak_change_of_the_finest"] = Convergence::change(one.peak);
    law["energy_change_of_the_finest"] = Convergence::change(one.released);
    for (std::size_t k = 0; k < one.pixel_sizes.size(); ++k) {
      law["pixel_size_m"].push_back(1e-3 * one.pixel_sizes[k]);
      law["peak_stress_Pa"].push_back(reproduce::json_of(one.peak[k]));
      law["released_J_per_m"].push_back(reproduce::json_of(one.released[k]));
    }
  }
  return json;
}

Section evaluate_objectivity(const Effort& effort, const TrialResults& outcomes) {
  std::vector<Convergence> all;
  for (const Law& law : laws()) all.push_back(convergence_of(law, effort, outcomes));
  const std::string means = output::side_by_side(
      "even",
      output::chart_figure(
          means_chart("Peak against pixel size", {"Peak stress", "MPa"}, 1e6, all, &Convergence::peak), 480,
          300, "Mean peak against the size of the pixels."),
      output::chart_figure(
          means_chart("Energy against pixel size", {"Energy", "J/m"}, 1, all, &Convergence::released), 480,
          300, "Mean energy of all cracks against the size of the pixels."));
  return {output::paragraph(text_of(effort, all)) + means +
              output::side_by_side("even", half_html(all[0]), half_html(all[1])),
          json_of_all(all),
          {}};
}

}  // namespace

Figure objectivity_figure() {
  return {{"objectivity"},
          "Beyond the paper: the size of the pixels",
          objectivity_trials,
          {},
          evaluate_objectivity};
}

}  // namespace app::reproduce
