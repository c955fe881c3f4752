#include "apps/statistics/curve.hpp"

#include <algorithm>
#include <cmath>

#include "apps/statistics/statistics.hpp"

namespace app {

bool Curve::has_peak() const {
  const double highest = peak_stress();
  const auto lowest = *std::min_element(stress.begin() + static_cast<std::ptrdiff_t>(peak()), stress.end());
  return highest > 0 && lowest <= (1 - mpm::lost_after_peak) * highest;
}

Curve stress_curve(const mpm::Result& result) {
  Curve curve;
  for (const mpm::HistoryRow& row : result.history) {
    if (!curve.empty() && row.strain < curve.strain.back()) continue;
    curve.strain.push_back(row.strain);
    curve.stress.push_back(row.stress);
  }
  return curve;
}

Curve normalised(const mpm::Result& result) {
  Curve curve = stress_curve(result);
  for (double& strain : curve.strain) strain /= result.peak_strain;
  for (double& stress : curve.stress) stress /= result.peak_stress;
  return curve;
}

double value_at(const Curve& curve, double strain) {
  const auto right = std::lower_bound(curve.strain.begin(), curve.strain.end(), strain);
  if (right == curve.strain.end()) return no_number;
  const auto i = static_cast<std::size_t>(right - curve.strain.begin());
  if (*right == strain) return curve.stress[i];
  if (i == 0) return no_number;
  const double share = (strain - curve.strain[i - 1]) / (curve.strain[i] - curve.strain[i - 1]);
  return curve.stress[i - 1] + share * (curve.stress[i] - curve.stress[i - 1]);
}

std::vector<double> even_axis(double end, int count) {
  std::vector<double> axis;
  for (int i = 0; i < count; ++i) axis.push_back(end * i / (count - 1));
  return axis;
}

CurveBand band_of(const std::vector<Curve>& curves, const std::vector<double>& axis, double tail) {
  CurveBand band;
  for (const double x : axis) {
    std::vector<double> values;
    for (const Curve& curve : curves) values.push_back(value_at(curve, x));
    const bool reached = !values.empty() && finite_of(values).size() == values.size();
    band.x.push_back(x);
    band.mean.push_back(reached ? spread_of(values).mean : no_number);
    band.low.push_back(reached ? quantile_of(values, tail) : no_number);
    band.high.push_back(reached ? quantile_of(values, 1 - tail) : no_number);
  }
  return band;
}

double mean_distance(const CurveBand& band, const std::function<double(double)>& reference, double from,
                     double to) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    const double distance = std::abs(band.mean[i] - reference(band.x[i]));
    if (band.x[i] < from || band.x[i] > to || !std::isfinite(distance)) continue;
    sum += distance;
    ++count;
  }
  return count > 0 ? sum / count : no_number;
}

void drop_maps(mpm::Result& result) {
  for (auto* map : {&result.failure_strain, &result.crush_strain, &result.end_x, &result.end_y})
    map->resize(0, 0);
  for (auto& map : result.deformation) map.resize(0, 0);
  result.failure_mode.resize(0, 0);
  result.extra_failure_strain.clear();
  result.extra_failure_mode.clear();
}

std::size_t peak_row(const mpm::Result& result) {
  const auto lower = [](const mpm::HistoryRow& a, const mpm::HistoryRow& b) { return a.stress < b.stress; };
  const auto peak = std::max_element(result.history.begin(), result.history.end(), lower);
  return static_cast<std::size_t>(peak - result.history.begin());
}

double drop_ratio(const mpm::Result& result, double share) {
  double farthest = 0;
  for (std::size_t row = peak_row(result); row < result.history.size(); ++row) {
    farthest = std::max(farthest, result.history[row].strain);
    if (result.history[row].stress < share * result.peak_stress) return farthest / result.peak_strain;
  }
  return no_number;
}

}  // namespace app
