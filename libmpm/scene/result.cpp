#include "libmpm/scene/result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {

double platen_imbalance(const HistoryRow& row) {
  const double sum = std::abs(row.stress_top) + std::abs(row.stress_bottom);
  return sum > 0 ? std::abs(row.stress_top - row.stress_bottom) / sum : 0;
}

const std::array<HistoryColumn, 15>& history_columns() {
  using Row = HistoryRow;
  static const std::array<HistoryColumn, 15> columns{{
      {"time", "s", "time since the start", &Row::time},
      {"strain", "1",
       "platen displacement over height, positive in the direction of the loading; without platens the "
       "distance of a free flight",
       &Row::strain},
      {"stress", "Pa",
       "mean of the reactions of both platens over the width, positive in the direction of the loading; "
       "without platens the "
       "sum of the reactions of the lower and the upper edge",
       &Row::stress},
      {"stress_top", "Pa", "reaction of the top platen over the width", &Row::stress_top},
      {"stress_bottom", "Pa", "reaction of the bottom platen over the width", &Row::stress_bottom},
      {"platen_work", "J/m", "work of the platens so far, per metre of thickness", &Row::platen_work},
      {"kinetic", "J/m", "kinetic energy, per metre of thickness", &Row::kinetic},
      {"elastic", "J/m", "elastic energy, per metre of thickness", &Row::elastic},
      {"released", "J/m", "elastic energy that failing points have lost so far, per metre of thickness",
       &Row::released},
      {"damped", "J/m", "energy dissipated by local damping so far, per metre of thickness", &Row::damped},
      {"left", "J/m", "energy of the points that have left so far, per metre of thickness", &Row::left},
      {"tension_failures", "1", "points that have failed in tension so far", &Row::tension_failures},
      {"shear_failures", "1", "points that have failed in shear so far", &Row::shear_failures},
      {"left_points", "1", "points that have left through open edges so far", &Row::left_points},
      {"moving_points", "1", "moving points; 0 during small strain", &Row::moving_points},
  }};
  return columns;
}

double fall_after_peak(const Result& result) {
  if (!(result.peak_stress > 0)) return 0;
  const auto& rows = result.history;
  // Along a path that goes back, the strain of the peak may have been passed before.
  const auto is_peak = [&](const HistoryRow& row) {
    return row.strain == result.peak_strain && row.stress >= result.peak_stress;
  };
  auto peak = std::find_if(rows.begin(), rows.end(), is_peak);
  if (peak == rows.end())
    peak = std::find_if(rows.begin(), rows.end(),
                        [&](const HistoryRow& row) { return row.strain >= result.peak_strain; });
  double least = result.peak_stress;
  for (auto row = peak; row != rows.end(); ++row)
    if (row != peak) least = std::min(least, row->stress);
  return 1 - least / result.peak_stress;
}

bool peak_reached(const Result& result) { return fall_after_peak(result) >= lost_after_peak; }

double peak_of(const Result& result, double Result::*figure) {
  return peak_reached(result) ? result.*figure : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mpm
