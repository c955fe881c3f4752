/// The aggregates of a picture as a sample of the aggregates of the concrete; empirical distributions and the
/// distance between two of them.
#pragma once

#include <cstddef>
#include <vector>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// A value, in any unit, and its weight.
struct WeightedValue {
  double value = 0;   ///< unit of the caller
  double weight = 1;  ///< [-], > 0
};

/// Empirical distribution function: below[i] is the share of the weight of values up to value[i].
struct Distribution {
  std::vector<double> value;  ///< increasing
  std::vector<double> below;  ///< [-], increasing to 1
};

/// Distribution of weighted values; empty for no values.
[[nodiscard]] Distribution distribution_of(const std::vector<WeightedValue>& values);

/// Pooled samples with equal weight for each sample; empty samples are ignored.
class PooledDistribution {
 public:
  explicit PooledDistribution(const std::vector<std::vector<WeightedValue>>& samples);

  /// Distribution of all samples.
  [[nodiscard]] Distribution all() const { return without(empty_.size()); }
  /// Distribution without one sample, by its index.
  [[nodiscard]] Distribution without(std::size_t sample) const;

 private:
  struct Part {
    double value;
    double share;  // of the weight of its sample
    std::size_t sample;
  };
  std::vector<Part> parts_;  // by increasing value
  std::vector<bool> empty_;  // per sample
};

/// Share of the weight up to a value [-].
[[nodiscard]] double share_up_to(const Distribution& distribution, double value);

/// Smallest value up to which at least this share [-] of the weight lies; NaN for an empty distribution.
[[nodiscard]] double quantile(const Distribution& distribution, double share);

/// Distance between two distributions of values >= 0.
struct DistributionDistance {
  double largest = 0;  ///< largest difference of the shares [-] (Kolmogorov, Smirnov)
  double mean = 0;     ///< area between them, in the unit of the values (Kantorovich)
};

/// Distance; both values are NaN if a distribution is empty.
[[nodiscard]] DistributionDistance distance_between(const Distribution& first, const Distribution& second);

/// Figures of one aggregate.
struct SampledAggregate {
  double diameter = 0;  ///< of the circle of the same area [m]
  double aspect = 1;    ///< short over long axis of the ellipse of the same second moments [-]
  double angle = 0;     ///< from x to the long axis [rad], in [0, pi)
  double weight = 1;    ///< number of aggregates of the concrete that it represents [-]

  [[nodiscard]] double area() const;           ///< [m^2]
  [[nodiscard]] double weighted_area() const;  ///< [m^2]
};

/// Sizes and shapes of the aggregates of a picture.
///
/// The size and shape of an aggregate that the border cuts are unknown, so it is omitted. Large ones are cut
/// more often, so each whole one has the weight 1 / p, where p = (W - w) (H - h) / (W H) is the probability
/// that its bounding box of w x h lies inside a window of W x H. A cut aggregate whose visible area exceeds
/// that of the largest whole one would be missed: it counts once, with its visible part. If no aggregate is
/// cut, the border is a wall (a cast or generated specimen), and all weights are 1. Source: Miles (1974),
/// Lantuejoul (1978); Baddeley, Jensen (2005), Stereology for Statisticians, ch. 10.
struct AggregateSample {
  std::vector<SampledAggregate> aggregates;  ///< largest first
  int cut = 0;                               ///< number of aggregates that the border cuts
  double cut_share = 0;                      ///< share of the visible aggregate area in cut aggregates [-]
  int parts = 0;                             ///< number of cut aggregates that count with their visible part

  /// Number of whole aggregates.
  [[nodiscard]] int whole() const { return static_cast<int>(aggregates.size()) - parts; }
};

/// Whether an inclusion touches the border of the mask.
[[nodiscard]] bool is_cut(const Inclusion& inclusion, const LabelledMask& mask);

/// The sample of a specimen.
[[nodiscard]] AggregateSample sample_aggregates(const Specimen& specimen);

/// Diameters [m] with the weighted area [m^2] as weight.
[[nodiscard]] std::vector<WeightedValue> sizes_by_area(const AggregateSample& sample);

}  // namespace specimen
