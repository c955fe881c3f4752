#include "apps/drawing/strain_unit.hpp"

#include <algorithm>
#include <cmath>

#include "apps/text/text.hpp"

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

std::string strain_words(const mpm::Result& result, double strain, int decimals) {
  const StrainUnit unit = strain_unit(result);
  std::string words = rounded(unit.per_strain * strain) + " " + unit.name;
  if (result.peak_strain > 0)
    words += ", " + percent(strain / result.peak_strain, decimals) + " of the peak strain";
  return words;
}

}  // namespace output
