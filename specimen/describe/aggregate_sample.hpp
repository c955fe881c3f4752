/// The aggregates of a picture as a sample of those of the concrete.
#pragma once

#include <vector>

#include "specimen/describe/distribution.hpp"
#include "specimen/body/specimen.hpp"

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
/// box of w x h lies in a window of W x H. Cut ones of which more is seen than the largest whole one has
/// would be missed: they count, once, with what is seen of them. Where none is cut, the border is no window
/// but a wall (a cast specimen, or one that was generated), and all weights are 1. Source: Miles (1974),
/// Lantuejoul (1978); Baddeley, Jensen (2005), Stereology for Statisticians, ch. 10.
struct AggregateSample {
  std::vector<SampledAggregate> aggregates;  ///< largest first
  int cut = 0;                               ///< number of those that the border cuts
  double cut_share = 0;                      ///< share of the visible aggregate area that these hold [-]
  int parts = 0;                             ///< number of these that count with what is seen of them

  [[nodiscard]] int whole() const { return static_cast<int>(aggregates.size()) - parts; }
};

/// Whether an inclusion reaches the border of the mask.
[[nodiscard]] bool is_cut(const Inclusion& inclusion, const LabelledMask& mask);

[[nodiscard]] AggregateSample sample_aggregates(const Specimen& specimen);

/// Diameters [m] by weighted area.
[[nodiscard]] std::vector<WeightedValue> sizes_by_area(const AggregateSample& sample);

}  // namespace specimen
