#include "apps/report/specimen_charts.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "specimen/pack/grading.hpp"
#include "specimen/describe/statistics.hpp"

namespace output {
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
    series.push_back(passing(specimen::named_grading(name, least, largest), name, inks[i]));
  }
  series.push_back(passing(specimen::named_grading("fuller", least, largest), "Fuller", Ink::fifth));
  series.push_back(
      passing(specimen::named_grading("fuller", least, largest, true), "Fuller, in a cut", Ink::muted));
  return series;
}

}  // namespace output
