/// Distributions of a figure over a sample, and how far two of them lie apart.
/// The aggregates of a picture as a sample of those of the concrete.
#pragma once

#include <cstddef>
#include <vector>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// A value and how much it counts.
struct WeightedValue {
  double value = 0;
  double weight = 1;  ///< > 0
};

/// A distribution that rises in steps: below[i] is the share of the weight of values up to value[i].
struct Distribution {
  std::vector<double> value;  ///< rising
  std::vector<double> below;  ///< [-], rising to 1
};

[[nodiscard]] Distribution distribution_of(const std::vector<WeightedValue>& values);

/// Samples put together, each with the same say; empty ones have none.
class PooledDistribution {
 public:
  explicit PooledDistribution(const std::vector<std::vector<WeightedValue>>& samples);

  [[nodiscard]] Distribution all() const { return without(empty_.size()); }
  /// Of all but one of the samples.
  [[nodiscard]] Distribution without(std::size_t sample) const;

 private:
  struct Part {
    double value;
    double share;  // of the weight of its sample
    std::size_t sample;
  };
  std::vector<Part> parts_;  // rising
  std::vector<bool> empty_;  // per sample
};

/// Share of the weight up to a value [-].
[[nodiscard]] double share_up_to(const Distribution& distribution, double value);

/// Smallest value up to which there is at least that share of the weight; NaN of an empty distribution.
[[nodiscard]] double quantile(const Distribution& distribution, double share);

/// How far two distributions of values >= 0 lie apart.
struct DistributionDistance {
  double largest = 0;  ///< largest difference of the shares [-] (Kolmogorov, Smirnov)
  double mean = 0;     ///< area between them: how far values are off in the mean (Kantorovich)
};

/// Both NaN when one of them is empty.
[[nodiscard]] DistributionDistance distance_between(const Distribution& first, const Distribution& second);

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
