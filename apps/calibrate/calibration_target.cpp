#include "apps/calibrate/calibration_target.hpp"

#include <algorithm>
#include <cmath>

namespace app {
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
Figures curve_figures(const TargetCurve& curve, const StressAt& stress_at_strain) {
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
    stress += stress_at(run, strain * run.peak_strain / peak.strain) / run.peak_stress;
  return peak.stress * stress / static_cast<double>(runs.size());
}

Figures figures_of(const Target& target, const std::vector<SeedRun>& runs) {
  if (target.curve.empty()) return peak_figures(target, mean_peak(runs));
  return curve_figures(target.curve, [&](double strain) { return mean_stress_at(runs, strain); });
}

Figures figures_of(const Target& target) {
  if (target.curve.empty())
    return peak_figures(target, {target.peak_stress.value_or(0), target.peak_strain.value_or(0)});
  const SeedRun wanted{0, 0, 0, target.curve.strain, target.curve.stress};
  return curve_figures(target.curve, [&](double strain) { return stress_at(wanted, strain); });
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
