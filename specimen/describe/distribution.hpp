/// Distributions of a figure over a sample, and how far two of them lie apart.
#pragma once

#include <cstddef>
#include <vector>

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

}  // namespace specimen
