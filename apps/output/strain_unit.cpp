#include "apps/output/strain_unit.hpp"

#include <algorithm>
#include <cmath>

namespace output {

StrainUnit strain_unit(double largest_strain) {
  if (largest_strain >= 0.01) return {"%", 1e2};
  return {"microstrain", 1e6};
}

StrainUnit strain_unit(const mpm::Result& result) {
  double largest = 0;
  for (const mpm::HistoryRow& row : result.history)
    if (std::isfinite(row.strain)) largest = std::max(largest, row.strain);
  return strain_unit(largest);
}

}  // namespace output
