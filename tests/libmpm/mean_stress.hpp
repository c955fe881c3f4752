/// Stress of a run, smoothed: each failure rings, and the waves of two runs do not keep step.
#pragma once

#include <algorithm>

#include "libmpm/scene/result.hpp"

namespace samples {

/// Mean stress of a history over a stretch of strain.
inline double mean_stress(const mpm::Result& result, double from, double to) {
  double area = 0;
  for (std::size_t i = 1; i < result.history.size(); ++i) {
    const auto& a = result.history[i - 1];
    const auto& b = result.history[i];
    const double begin = std::max(from, a.strain);
    const double end = std::min(to, b.strain);
    if (end <= begin) continue;
    const auto at = [&](double strain) {
      return a.stress + (b.stress - a.stress) * (strain - a.strain) / (b.strain - a.strain);
    };
    area += 0.5 * (at(begin) + at(end)) * (end - begin);
  }
  return area / (to - from);
}

}  // namespace samples
