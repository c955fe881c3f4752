#include "apps/report/run_charts.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "apps/drawing/ticks.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"
#include "specimen/body/error.hpp"
#include "specimen/describe/statistics.hpp"
#include "specimen/pack/grading.hpp"

namespace output {
namespace {

using mpm::HistoryRow;

template <class Value>
std::vector<double> column(const std::vector<HistoryRow>& history, Value value) {
  std::vector<double> values(history.size());
  std::transform(history.begin(), history.end(), values.begin(), value);
  return values;
}

Axis strain_axis(const RunRecord& record) {
  return {capitalised(name_of_strain(record.scene)), strain_unit(record.result).name};
}

template <class Value>
Series against_strain(const RunRecord& record, const std::string& name, Ink ink, Value value,
                      bool dashed = false) {
  const auto& history = record.result.history;
  const double per_strain = strain_unit(record.result).per_strain;
  return {name, column(history, [per_strain](const HistoryRow& row) { return per_strain * row.strain; }),
          column(history, value), ink, dashed};
}

/// Strains [-] at which the points of a phase failed, rising.
struct PhaseStrains {
  std::vector<double> tension, shear;
};
struct FailureStrains {
  std::vector<PhaseStrains> by_label;
  std::vector<double> extra;  ///< of the extra points, in both modes
};
FailureStrains failure_strains(const RunRecord& record) {
  FailureStrains strains;
  const mpm::Result& result = record.result;
  const auto& labels = record.specimen.mask.labels.data;
  strains.by_label.resize(record.specimen.mask.phases.size());
  for (Eigen::Index pixel = 0; pixel < result.failure_strain.size(); ++pixel) {
    PhaseStrains& phase = strains.by_label[labels[static_cast<std::size_t>(pixel)]];
    const auto mode = static_cast<mpm::FailureMode>(result.failure_mode.data()[pixel]);
    if (mode == mpm::FailureMode::none) continue;
    (mode == mpm::FailureMode::tension ? phase.tension : phase.shear)
        .push_back(static_cast<double>(result.failure_strain.data()[pixel]));
  }
  for (std::size_t i = 0; i < result.extra_failure_mode.size(); ++i)
    if (result.extra_failure_mode[i] != 0)
      strains.extra.push_back(static_cast<double>(result.extra_failure_strain[i]));
  for (PhaseStrains& phase : strains.by_label)
    for (auto* list : {&phase.tension, &phase.shear}) std::sort(list->begin(), list->end());
  std::sort(strains.extra.begin(), strains.extra.end());
  return strains;
}

/// How many of the strains, which rise, are reached at each row of the history.
Series so_far(const RunRecord& record, const std::string& name, Ink ink, const std::vector<double>& strains,
              bool dashed = false) {
  double farthest = 0;  // where the platens have gone back, the maps hold the largest strain until then
  return against_strain(
      record, name, ink,
      [&](const HistoryRow& row) {
        farthest = std::max(farthest, row.strain);
        // The maps hold strains in 32 bits.
        const auto reached = static_cast<double>(static_cast<float>(farthest));
        return static_cast<double>(std::upper_bound(strains.begin(), strains.end(), reached) -
                                   strains.begin());
      },
      dashed);
}

std::string peak_text(const mpm::Result& result, const StrainUnit& unit) {
  return (mpm::peak_reached(result) ? "peak " : "no peak: largest ") + rounded(1e-6 * result.peak_stress) +
         " MPa at " + rounded(unit.per_strain * result.peak_strain) + " " + unit.name;
}

}  // namespace

Series stress_series(const std::string& name, Ink ink, const mpm::Result& result, double per_strain) {
  return {name, column(result.history, [=](const HistoryRow& row) { return per_strain * row.strain; }),
          column(result.history, [](const HistoryRow& row) { return 1e-6 * row.stress; }), ink};
}

namespace {

/// Force of the leading load against the gauge that controls the run, or else against its displacement.
Chart force_chart(const RunRecord& record) {
  const mpm::Result& result = record.result;
  const auto& rows = result.history;
  const auto force = [&](const HistoryRow& row) { return 1e-3 * leading_force(record.scene, row.stress); };
  const auto& gauges = record.scene.fixture.gauges;
  const auto control =
      std::find_if(gauges.begin(), gauges.end(), [](const auto& one) { return one.controls; });
  std::vector<double> x = column(
      rows, [&](const HistoryRow& row) { return 1e3 * leading_displacement(record.scene, row.strain); });
  std::string name = "Displacement of the load";
  if (control != gauges.end()) {
    name = control->name;
    x = result.gauges[static_cast<std::size_t>(control - gauges.begin())].values;
    for (double& value : x) value *= 1e3;
  }
  Chart chart{"Force against " + (control != gauges.end() ? name : "displacement"),
              {name, "mm"},
              {"Force", "kN"},
              {},
              {}};
  const std::vector<double> y = column(rows, force);
  chart.series.push_back({"force", x, y, Ink::first});
  if (result.peak_stress > 0) {
    const auto at = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
    chart.markers.push_back({x[at], y[at],
                             (mpm::peak_reached(result) ? "peak " : "no peak: largest ") + rounded(y[at]) +
                                 " kN at " + rounded(x[at]) + " mm"});
  }
  return chart;
}

}  // namespace

Chart stress_chart(const RunRecord& record) {
  if (record.scene.fixture.has_loads()) return force_chart(record);
  const mpm::Result& result = record.result;
  const StrainUnit unit = strain_unit(result);
  Chart chart{"Stress against strain in " + name_of_loading(record.scene),
              strain_axis(record),
              {capitalised(name_of_stress(record.scene)), "MPa"},
              {},
              {}};
  chart.series.push_back(stress_series("stress", Ink::first, result, unit.per_strain));
  if (result.peak_stress > 0)
    chart.markers.push_back(
        {unit.per_strain * result.peak_strain, 1e-6 * result.peak_stress, peak_text(result, unit)});
  return chart;
}

Chart energy_chart(const RunRecord& record) {
  Chart chart{"Energies against strain", strain_axis(record), {"Energy", "J/m"}, {}, {}};
  const auto add = [&](const std::string& name, Ink ink, double HistoryRow::*member) {
    chart.series.push_back(
        against_strain(record, name, ink, [member](const HistoryRow& row) { return row.*member; }));
  };
  const auto& history = record.result.history;
  const double at_start = history.empty() ? 0 : history.front().kinetic;
  chart.series.push_back(against_strain(
      record, has_platens(record.scene) ? "work of the platens" : "initial energy", Ink::text,
      [at_start](const HistoryRow& row) { return at_start + row.platen_work; }, true));
  add("elastic", Ink::first, &HistoryRow::elastic);
  add("released", Ink::second, &HistoryRow::released);
  const bool moves = record.scene.method == mpm::SolverMethod::explicit_;
  if (moves) add("kinetic", Ink::third, &HistoryRow::kinetic);
  if (moves && record.scene.local_damping > 0) add("damped", Ink::fourth, &HistoryRow::damped);
  if (!history.empty() && history.back().left_points > 0) add("left", Ink::fifth, &HistoryRow::left);
  return chart;
}

Chart failure_chart(const RunRecord& record) {
  Chart chart{"Failed points against strain", strain_axis(record), {"Failed points", ""}, {}, {}};
  const FailureStrains strains = failure_strains(record);
  std::size_t lines = 0;
  for (std::size_t label = 0; label < strains.by_label.size(); ++label) {
    const auto& [tension, shear] = strains.by_label[label];
    if (tension.empty() && shear.empty()) continue;
    const std::string phase = phase_word(record.specimen.mask.phases[label]);
    const Ink ink = ink_of_series(lines++);
    if (!tension.empty()) chart.series.push_back(so_far(record, phase + " in tension", ink, tension));
    if (!shear.empty()) chart.series.push_back(so_far(record, phase + " in shear", ink, shear, true));
  }
  if (!strains.extra.empty())
    chart.series.push_back(so_far(record, "extra points", Ink::muted, strains.extra));
  return chart;
}

Chart failure_strain_chart(const RunRecord& record) {
  constexpr int classes = 60;
  const StrainUnit unit = strain_unit(record.result);
  Chart chart{"Strain at failure", strain_axis(record), {"Pixels that failed", ""}, {}, {}};
  const double end = largest_strain(record.result);
  if (!(end > 0)) return chart;
  const FailureStrains strains = failure_strains(record);
  const auto add = [&](const std::string& name, Ink ink, auto mode) {
    std::vector<double> counts(classes, 0.0);
    bool any = false;
    for (const auto& phase : strains.by_label)
      for (const double strain : phase.*mode) {
        ++counts[static_cast<std::size_t>(
            std::clamp(static_cast<int>(classes * strain / end), 0, classes - 1))];
        any = true;
      }
    if (!any) return;
    Series series{name, {}, {}, ink};
    for (int i = 0; i < classes; ++i)
      for (const int edge : {i, i + 1}) {  // the outline of a bar
        series.x.push_back(unit.per_strain * end * edge / classes);
        series.y.push_back(counts[static_cast<std::size_t>(i)]);
      }
    chart.series.push_back(std::move(series));
  };
  add("in tension", Ink::first, &PhaseStrains::tension);
  add("in shear", Ink::second, &PhaseStrains::shear);
  return chart;
}

namespace {

/// Smallest and largest diameter [m].
std::pair<double, double> sizes(const specimen::Specimen& specimen) {
  const auto [least, largest] = std::minmax_element(
      specimen.inclusions.begin(), specimen.inclusions.end(),
      [](const auto& a, const auto& b) { return a.equivalent_diameter < b.equivalent_diameter; });
  return {least->equivalent_diameter, largest->equivalent_diameter};
}

Series passing(const specimen::Grading& grading, const std::string& name, Ink ink) {
  Series series{name, {}, {}, ink, true};
  double below = 100;
  for (const specimen::SizeClass& size : grading) {  // in falling order
    if (series.x.empty()) {
      series.x.push_back(1e3 * size.d_max);
      series.y.push_back(below);
    }
    below = std::max(0.0, below - 100 * size.share);
    series.x.push_back(1e3 * size.d_min);
    series.y.push_back(below);
  }
  std::reverse(series.x.begin(), series.x.end());
  std::reverse(series.y.begin(), series.y.end());
  return series;
}

constexpr double finest_sieve = 0.25e-3;  ///< of DIN 1045-2 [m]

/// A standard curve between two sizes; none where it has no aggregate between them.
void add_reference(std::vector<Series>& series, const std::string& grading, double least, double largest,
                   const std::string& name, Ink ink, bool in_plane_cut = false) {
  try {
    series.push_back(passing(specimen::named_grading(grading, least, largest, in_plane_cut), name, ink));
  } catch (const specimen::Error&) {  // it says nothing of such sizes
  }
}

/// Sieves of DIN 1045-2 by their largest grain [mm].
std::string family_of(double largest) { return largest <= 8e-3 ? "8" : largest <= 16e-3 ? "16" : "32"; }

}  // namespace

Chart sieve_chart(const specimen::Specimen& specimen) {
  Chart chart{"Sieve curve of the aggregates", {"Diameter", "mm"}, {"Passing, by area", "%"}, {}, {}};
  if (specimen.inclusions.empty()) return chart;
  Series series{"this specimen", {}, {}, Ink::first};
  for (const specimen::Passing& point : specimen::sieve_curve(specimen.inclusions, {})) {
    series.x.push_back(1e3 * point.diameter);
    series.y.push_back(100 * point.reached);
  }
  chart.series.push_back(std::move(series));
  return chart;
}

std::vector<Series> sieve_references(const specimen::Specimen& specimen) {
  if (specimen.inclusions.empty()) return {};
  const auto [least, largest] = sizes(specimen);
  if (!(largest > 1.05 * least)) return {};  // of one size: no curve between them
  std::vector<Series> series;
  const Ink inks[] = {Ink::second, Ink::third, Ink::fourth};
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::string(1, "ABC"[i]) + family_of(largest);
    add_reference(series, name, std::max(least, finest_sieve), largest, name, inks[i]);
  }
  add_reference(series, "fuller", least, largest, "Fuller", Ink::fifth);
  add_reference(series, "fuller", least, largest, "Fuller, plane cut", Ink::muted, true);
  return series;
}

}  // namespace output
