/// A run that was never computed.
#pragma once

#include <algorithm>

#include "libmpm/scene/result.hpp"

namespace test {

/// Stress rises evenly to its peak, then falls evenly to nothing at drop_ratio times the strain at the peak,
/// and stays there to three times that strain.
inline mpm::Result triangle(double peak_stress, double peak_strain, double drop_ratio = 2) {
  mpm::Result result;
  result.peak_stress = peak_stress;
  result.peak_strain = peak_strain;
  for (int i = 0; i <= 300; ++i) {
    const double x = i / 100.0;
    const double y = x <= 1 ? x : std::max(0.0, (drop_ratio - x) / (drop_ratio - 1));
    mpm::HistoryRow row;
    row.strain = x * peak_strain;
    row.stress = y * peak_stress;
    result.history.push_back(row);
  }
  result.tension_failures = 90;
  result.shear_failures = 10;
  return result;
}

}  // namespace test
