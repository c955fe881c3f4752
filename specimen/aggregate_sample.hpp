/// The aggregates of a picture as a sample of those of the concrete.
#pragma once

#include <vector>

#include "specimen/specimen.hpp"

namespace specimen {

/// One aggregate, in figures.
struct SampledAggregate {
  double diameter = 0;  ///< of the circle of the same area [m]
  double aspect = 1;    ///< short over long axis of the ellipse of the same second moments [-]
  double angle = 0;     ///< of the long axis against x, [0, pi) [rad]
  double weight = 1;    ///< how many of the concrete it stands for [-]

  [[nodiscard]] double area() const;           ///< [m^2]
  [[nodiscard]] double weighted_area() const;  ///< [m^2]
};

/// What a picture says about sizes and shapes.
///
/// Aggregates that the border cuts show neither, so they are left out; large ones are cut more often, and
/// each whole one stands for 1 / p, where p = (W - w) (H - h) / (W H) is the share of places at which its
/// box of w x h lies in a window of W x H. Where none is cut, the border is no window but a wall (a cast
/// specimen, or one that was generated), and all weights are 1. Where cut ones hold more than three quarters
/// of the aggregate area, the whole ones tell nothing of them: all count then, with what is seen of them.
/// Source: Miles (1974), Lantuejoul (1978); Baddeley, Jensen (2005), Stereology for Statisticians, ch. 10.
struct AggregateSample {
  std::vector<SampledAggregate> aggregates;  ///< largest first
  int cut = 0;                               ///< number of those that the border cuts
  double cut_share = 0;                      ///< share of the visible aggregate area that these hold [-]
  bool with_parts = false;                   ///< cut ones count too, with what is seen of them
};

/// Whether an inclusion reaches the border of the mask.
[[nodiscard]] bool is_cut(const Inclusion& inclusion, const LabelledMask& mask);

[[nodiscard]] AggregateSample sample_aggregates(const Specimen& specimen);

/// A distribution of area over diameter: below[i] is the share of the area in aggregates up to diameter[i].
struct SizeCurve {
  std::vector<double> diameter;  ///< [m], rising
  std::vector<double> below;     ///< [-], rising to 1
};

/// Weighted size curve of samples put together, each of them with the same say.
[[nodiscard]] SizeCurve size_curve(const std::vector<const AggregateSample*>& samples);

/// Smallest diameter up to which aggregates hold at least the share of the area [m]; NaN without any.
[[nodiscard]] double diameter_at(const SizeCurve& curve, double share);

/// How far two size curves lie apart.
struct SizeDistance {
  double largest = 0;  ///< largest difference of the shares [-] (Kolmogorov, Smirnov)
  double mean = 0;     ///< area between the curves: how far diameters are off in the mean [m] (Kantorovich)
};

/// Both NaN when one of the curves is empty.
[[nodiscard]] SizeDistance distance_between(const SizeCurve& first, const SizeCurve& second);

}  // namespace specimen
