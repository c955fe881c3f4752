/// Stress-strain curves of several runs beside each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "libmpm/scene/result.hpp"

namespace app {

/// Stress over strain, positive in the direction of the loading.
struct Curve {
  std::vector<double> strain;  ///< does not fall [-]
  std::vector<double> stress;  ///< same length [Pa]

  [[nodiscard]] bool empty() const { return strain.empty(); }
  [[nodiscard]] double last_strain() const { return strain.back(); }
  [[nodiscard]] double peak_stress() const { return stress[peak()]; }  ///< @pre not empty
  [[nodiscard]] double peak_strain() const { return strain[peak()]; }  ///< where the stress is highest

  /// Whether the highest stress is a peak, as mpm::peak_reached().   @pre not empty.
  [[nodiscard]] bool has_peak() const;

 private:
  [[nodiscard]] std::size_t peak() const {
    return static_cast<std::size_t>(std::max_element(stress.begin(), stress.end()) - stress.begin());
  }
};

/// Of a run. A path that snaps back is seen as by platens that never go back.
[[nodiscard]] Curve stress_curve(const mpm::Result& result);

/// Both over their values at the peak [-].   @pre the run has a peak.
[[nodiscard]] Curve normalised(const mpm::Result& result);

/// Between the points of the curve on a straight line; NaN outside of it.
[[nodiscard]] double value_at(const Curve& curve, double strain);

/// 0 ... end in equal steps.   @pre count >= 2.
[[nodiscard]] std::vector<double> even_axis(double end, int count);

/// Several curves on one axis; NaN where not all of them reach.
struct CurveBand {
  std::vector<double> x, mean, low, high;
};
/// @param tail  share of the curves that lies below the band, and above it [-]; 0 = it holds them all.
[[nodiscard]] CurveBand band_of(const std::vector<Curve>& curves, const std::vector<double>& axis,
                                double tail = 0);

/// Mean over from <= x <= to of the amount by which the mean of the band is off a reference; where either is
/// no number does not count. NaN where nothing counts.
[[nodiscard]] double mean_distance(const CurveBand& band, const std::function<double(double)>& reference,
                                   double from, double to);

/// Strain at which the stress has first fallen below a share of its peak, over the strain at the peak [-]:
/// the nearer to 1, the more brittle. NaN where the run ended before.
[[nodiscard]] double drop_ratio(const mpm::Result& result, double share);

/// So that many results take little memory: what was at every point goes.
void drop_maps(mpm::Result& result);

/// Row of the history at the peak.   @pre a history.
[[nodiscard]] std::size_t peak_row(const mpm::Result& result);

}  // namespace app
