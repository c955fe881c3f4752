#include "apps/calibrate/calibration_target.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/system/files.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

constexpr const char* header_form = "write a header such as strain,stress_MPa";

/// Where a quantity stands in every row.
struct Column {
  std::size_t index = 0;
  std::string unit;
};

class CurveReader : public TableReader {
 public:
  using TableReader::TableReader;

  Curve read(const std::string& text) {
    read_lines(text);
    check_whole();
    if (!complaints_.empty()) throw Rejected(Exit::data, complaints_);
    return curve_;
  }

 private:
  void read_header(const std::vector<CsvCell>& cells) override {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      take_column(cells[i], i, "strain", Dimension::ratio, strain_);
      take_column(cells[i], i, "stress", Dimension::pressure, stress_);
    }
    if (complaints_.empty() && !strain_) complain(1, "strain", "column missing", header_form);
    if (complaints_.empty() && !stress_) complain(1, "stress", "column missing", header_form);
  }

  /// Columns of other names, "stress_top_Pa" among them, are nobody's mistake.
  void take_column(const CsvCell& cell, std::size_t index, const std::string& name, Dimension dimension,
                   std::optional<Column>& column) {
    auto [heading, unit] = name_and_unit(cell);
    if (!heading.empty() && heading.front() == 'S') heading.front() = 's';
    if (heading != name) return;
    if (unit == "-" || unit == "1") unit.clear();
    const bool fits = unit.empty() ? dimension == Dimension::ratio : is_unit(unit, dimension);
    if (!fits && unit.find('_') != std::string::npos) return;
    if (!fits)
      complain(cell.column, cell.text, "needs the unit of a " + app::name(dimension), header_form);
    else if (column)
      complain(cell.column, cell.text, "column given twice", "", "remove one");
    else
      column = Column{index, unit};
  }

  void read_row(const std::vector<CsvCell>& cells) override {
    const auto strain = number_in(cells[strain_->index], "strain", strain_->unit, Dimension::ratio);
    const auto stress = number_in(cells[stress_->index], "stress", stress_->unit, Dimension::pressure);
    if (!strain || !stress) return;
    if (!(*strain >= 0 && *strain < 1))
      return complain(cells[strain_->index].column, "strain", cells[strain_->index].text,
                      "must lie in [0, 1), positive in the direction of the loading");
    if (!curve_.empty() && *strain < curve_.strain.back())
      return complain(
          cells[strain_->index].column, "strain", cells[strain_->index].text,
          "must not be below the one before, " + format_quantity(curve_.strain.back(), Dimension::ratio),
          "leave out rows in which the specimen is unloaded");
    curve_.strain.push_back(*strain);
    curve_.stress.push_back(*stress);
  }

  void check_whole() {
    if (!complaints_.empty()) return;
    if (!has_header()) return complain(0, "", "no header", header_form);
    if (curve_.strain.size() < 3)
      return complain(0, "", fmt::format("{} rows", curve_.strain.size()), "a curve needs at least 3");
    if (!(curve_.peak_stress() > 0))
      complain(0, "stress", "nowhere above 0", "must be positive in the direction of the loading",
               "turn its sign");
  }

  std::optional<Column> strain_, stress_;
  Curve curve_;
};

}  // namespace

Curve parse_target_curve(const std::string& text, const std::string& path) {
  return CurveReader(path).read(text);
}

Curve read_target_curve(const std::string& path) {
  return parse_target_curve(read_text_file(path, longest_table), path);
}

namespace {

constexpr int samples = 200;     ///< of a curve, evenly over its strains
constexpr int least_rows = 200;  ///< of the history over a curve
constexpr double beyond = 1.2;   ///< the last strain of a curve, for runs that are stretched

/// What is aimed at of a peak.
Figures peak_figures(const Target& target, const Peak& peak) {
  std::vector<double> figures;
  if (target.peak_stress) figures.push_back(std::log(peak.stress));
  if (target.peak_strain) figures.push_back(std::log(peak.strain));
  return Eigen::Map<Figures>(figures.data(), static_cast<Eigen::Index>(figures.size()));
}

template <class StressAt>
Figures curve_figures(const Curve& curve, const StressAt& stress_at_strain) {
  Figures figures(samples);
  const double first = curve.strain.front();
  for (int i = 0; i < samples; ++i) {
    const double share = (i + 0.5) / samples;
    figures[i] = stress_at_strain(first + share * (curve.last_strain() - first)) / curve.peak_stress();
  }
  return figures;
}

}  // namespace

Target Target::peak_of_curve() const { return {curve.peak_stress(), curve.peak_strain(), {}}; }

Peak mean_peak(const std::vector<SeedRun>& runs) {
  return {spread_of(runs, &SeedRun::peak_stress).mean, spread_of(runs, &SeedRun::peak_strain).mean};
}

double mean_stress_at(const std::vector<SeedRun>& runs, double strain) {
  const Peak peak = mean_peak(runs);
  double stress = 0;
  for (const SeedRun& run : runs)
    stress += stress_at(run.curve, strain * run.peak_strain / peak.strain) / run.peak_stress;
  return peak.stress * stress / static_cast<double>(runs.size());
}

Figures figures_of(const Target& target, const std::vector<SeedRun>& runs) {
  if (target.curve.empty()) return peak_figures(target, mean_peak(runs));
  return curve_figures(target.curve, [&](double strain) { return mean_stress_at(runs, strain); });
}

Figures figures_of(const Target& target) {
  if (target.curve.empty())
    return peak_figures(target, {target.peak_stress.value_or(0), target.peak_strain.value_or(0)});
  return curve_figures(target.curve, [&](double strain) { return stress_at(target.curve, strain); });
}

double mean_square(const Figures& figures, const Figures& wanted) {
  return (figures - wanted).squaredNorm() / static_cast<double>(wanted.size());
}

double misfit(const Target& target, const std::vector<SeedRun>& runs) {
  return std::sqrt(mean_square(figures_of(target, runs), figures_of(target)));
}

mpm::Scene scene_for(const Target& target, mpm::Scene scene) {
  if (target.curve.empty()) return scene;
  const double stop_strain = std::min(0.999, beyond * target.curve.last_strain());
  const double factor = stop_strain / scene.loading.stop_strain;
  scene.history_rows = std::max(least_rows, static_cast<int>(std::ceil(scene.history_rows * factor)));
  scene.loading.stop_strain = stop_strain;
  scene.loading.stop_drop.reset();
  return scene;
}

}  // namespace app
