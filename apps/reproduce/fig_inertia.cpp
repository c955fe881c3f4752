// Beyond the paper: what its peaks owe to inertia, and what to the cell.
#include <algorithm>
#include <cmath>

#include "apps/report/report_parts.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/text/figures.hpp"

namespace app::reproduce {
namespace {

constexpr int most_specimens = 3;

/// A way to compute the same specimen.
struct Way {
  std::string cell, motion;
  std::vector<Setting> settings;
  bool at_rest = false;  ///< without inertia: what the others of this cell are compared with
};

const std::vector<Way>& ways() {
  static const Setting pixel{"solver.cell", "pixel"}, damping{"solver.local_damping", "0.2"};
  static const Setting still{"solver.method", "quasi_static"}, broken{"loading.stop_drop", "0.3"};
  static const std::vector<Way> all{{"2 x 2", "explicit, as in the paper", {}},
                                    {"2 x 2", "explicit, damped", {damping}},
                                    {"2 x 2", "without inertia", {still, broken}, true},
                                    {"pixel", "explicit", {pixel}},
                                    {"pixel", "explicit, damped", {pixel, damping}},
                                    {"pixel", "without inertia", {pixel, still, broken}, true},
                                    {"1 x 1", "explicit", {{"solver.cell", "1 x 1"}}}};
  return all;
}

const std::vector<std::string>& tests_of_inertia() {
  static const std::vector<std::string> all{"tension", "compression", "two_aggregates"};
  return all;
}

int specimens_of(const Effort& effort) { return std::min(most_specimens, effort.repeats); }

Trial trial_of_way(const Effort& effort, const std::string& test, const Way& way, int seed) {
  if (test != "two_aggregates") return square_trial(effort, test, seed, way.settings);
  Trial trial{test, {{"damage.seed", std::to_string(seed)}}, false};
  for (const auto* more : {&way.settings, &effort.pair})
    trial.settings.insert(trial.settings.end(), more->begin(), more->end());
  return trial;
}

std::vector<Trial> inertia_trials(const Effort& effort) {
  std::vector<Trial> trials;
  for (const std::string& test : tests_of_inertia())
    for (const Way& way : ways())
      for (int seed = 1; seed <= specimens_of(effort); ++seed)
        trials.push_back(trial_of_way(effort, test, way, seed));
  return trials;
}

/// What a way gave in a test.
struct Peaks {
  const Way* way = nullptr;
  std::vector<double> stresses, strains;
  const mpm::Result* first = nullptr;  ///< of the first specimen
  double off = 0;                      ///< mean of peak stresses over those without inertia, less 1 [-]
  bool has_rest = false;               ///< there is a run without inertia of this cell
};

Peaks peaks_of(const Effort& effort, const TrialResults& outcomes, const std::string& test, const Way& way) {
  Peaks peaks{&way, {}, {}, nullptr};
  for (int seed = 1; seed <= specimens_of(effort); ++seed) {
    const mpm::Result& result = outcomes.of(trial_of_way(effort, test, way, seed)).result;
    if (seed == 1) peaks.first = &result;
    peaks.stresses.push_back(peak_of(result, &mpm::Result::peak_stress));
    peaks.strains.push_back(peak_of(result, &mpm::Result::peak_strain));
  }
  return peaks;
}

std::vector<Peaks> table_of_peaks(const Effort& effort, const TrialResults& outcomes,
                                  const std::string& test) {
  std::vector<Peaks> all;
  for (const Way& way : ways()) all.push_back(peaks_of(effort, outcomes, test, way));
  for (Peaks& one : all)
    for (const Peaks& rest : all)
      if (rest.way->at_rest && rest.way->cell == one.way->cell) {
        one.has_rest = true;
        one.off = spread_of(one.stresses).mean / spread_of(rest.stresses).mean - 1;
      }
  return all;
}

std::string inertia_of(const Peaks& peaks) {
  return peaks.way->at_rest ? "0" : peaks.has_rest ? output::percent(peaks.off) : "";
}

std::string html_of(const std::vector<Peaks>& all) {
  std::vector<std::vector<std::string>> rows;
  for (const Peaks& one : all)
    rows.push_back({one.way->cell + ", " + one.way->motion, megapascals(spread_of(one.stresses)),
                    microstrain(spread_of(one.strains)), inertia_of(one)});
  return output::number_table({"Cell and method", "Peak stress", "Peak strain", "Against no inertia"}, rows);
}

output::Chart chart_of(const std::string& test, const std::vector<Peaks>& all) {
  output::Chart chart{"First specimen, " + test, {"Strain", "microstrain"}, {"Stress", "MPa"}, {}, {}};
  for (const std::size_t i : {0U, 2U, 5U})
    chart.series.push_back(output::stress_series(all[i].way->cell + ", " + all[i].way->motion,
                                                 output::ink_of_series(chart.series.size()), *all[i].first));
  return chart;
}

/// "the peak lies 5.4 % below that without inertia".
std::string share_text(const std::vector<Peaks>& all) {
  const double off = all.front().off;
  return "the peak of the paper's way lies " + output::percent(std::abs(off)) +
         (off < 0 ? " below" : " above") + " that without inertia, with damping " +
         output::percent(std::abs(all[1].off)) + (all[1].off < 0 ? " below" : " above");
}

/// Whether the mean is inside the paper's band, or no farther from it than one run from another.
bool reaches_paper_band(const Peaks& peaks) {
  const PaperBand band;
  const auto reaches = [](const Spread& spread, double least, double largest) {
    return spread.mean + spread.deviation >= least && spread.mean - spread.deviation <= largest;
  };
  return reaches(spread_of(peaks.stresses), band.least_stress, band.largest_stress) &&
         reaches(spread_of(peaks.strains), band.least_strain, band.largest_strain);
}

std::string bands_text(const std::vector<Peaks>& all) {
  std::string inside;
  for (const Peaks& one : all)
    if (reaches_paper_band(one))
      inside += (inside.empty() ? "" : "; ") + one.way->cell + ", " + one.way->motion;
  return "The strengths of Table 1 were not fitted here. " +
         (inside.empty()
              ? "In no way do they give the paper's peak of two aggregates (1.40 to 2.09 MPa at 46 to "
                "103 microstrain)."
              : "They give the paper's peak of two aggregates (1.40 to 2.09 MPa at 46 to 103 "
                "microstrain), within a standard deviation, with: " +
                    inside + ".") +
         " With one point a cell the corners of a cell can move against each other without resistance, so "
         "that "
         "a crack needs no more than a column of single pixels, as with pixel cells.";
}

nlohmann::json json_of_peaks(const std::vector<Peaks>& all) {
  nlohmann::json json;
  for (const Peaks& one : all) {
    nlohmann::json row{{"cell", one.way->cell},
                       {"method", one.way->motion},
                       {"peak_stress_Pa", reproduce::json_of(spread_of(one.stresses))},
                       {"peak_strain", reproduce::json_of(spread_of(one.strains))}};
    if (one.has_rest) row["over_that_without_inertia"] = 1 + one.off;
    json.push_back(std::move(row));
  }
  return json;
}

Section evaluate_inertia(const Effort& effort, const TrialResults& outcomes) {
  std::vector<std::vector<Peaks>> all;
  nlohmann::json data;
  for (const std::string& test : tests_of_inertia()) {
    all.push_back(table_of_peaks(effort, outcomes, test));
    data[test] = json_of_peaks(all.back());
  }
  const std::string text =
      "The same specimens and strengths, " + std::to_string(specimens_of(effort)) +
      " of each test, with other cells and without inertia. In tension " + share_text(all[0]) +
      "; in compression " + share_text(all[1]) +
      ". A point that breaks at one blow sends out a wave, and the wave breaks its neighbours: this share of "
      "figures 5 to 14 is inertia, at any rate of loading. After the peak explicit curves ring; those "
      "without "
      "inertia drop. The cell changes the peaks as much: with 2 x 2 points a cell a row of single pixels "
      "cannot crack through.";
  std::string html = output::paragraph(text);
  html += output::side_by_side("even", output::chart_figure(chart_of("tension", all[0]), 480, 350, ""),
                               output::chart_figure(chart_of("compression", all[1]), 480, 350, ""));
  const char* titles[] = {"Tension", "Compression", "Two aggregates"};
  for (std::size_t i = 0; i < all.size(); ++i)
    html += "<h3>" + std::string(titles[i]) + "</h3>\n" + html_of(all[i]);
  return {html + output::paragraph(bands_text(all[2])), data, {}};
}

}  // namespace

Figure inertia_figure() {
  return {{"inertia"}, "Beyond the paper: inertia and the cell", inertia_trials, {}, evaluate_inertia};
}

}  // namespace app::reproduce
