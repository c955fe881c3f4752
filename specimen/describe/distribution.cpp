#include "specimen/describe/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace specimen {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

Distribution distribution_of(const std::vector<WeightedValue>& values) {
  return PooledDistribution({values}).all();
}

PooledDistribution::PooledDistribution(const std::vector<std::vector<WeightedValue>>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double whole = 0;
    for (const WeightedValue& one : samples[i]) whole += one.weight;
    for (const WeightedValue& one : samples[i]) parts_.push_back({one.value, one.weight / whole, i});
    empty_.push_back(samples[i].empty());
  }
  std::stable_sort(parts_.begin(), parts_.end(),
                   [](const Part& p, const Part& q) { return p.value < q.value; });
}

Distribution PooledDistribution::without(std::size_t sample) const {
  double voices = 0;
  for (std::size_t i = 0; i < empty_.size(); ++i) voices += i != sample && !empty_[i];
  Distribution distribution;
  double below = 0;
  for (const Part& part : parts_) {
    if (part.sample == sample) continue;
    below += part.share / voices;
    if (!distribution.value.empty() && distribution.value.back() == part.value) {
      distribution.below.back() = below;
    } else {
      distribution.value.push_back(part.value);
      distribution.below.push_back(below);
    }
  }
  if (!distribution.below.empty()) distribution.below.back() = 1;
  return distribution;
}

double share_up_to(const Distribution& distribution, double value) {
  const auto above = std::upper_bound(distribution.value.begin(), distribution.value.end(), value);
  if (above == distribution.value.begin()) return 0;
  return distribution.below[static_cast<std::size_t>(above - distribution.value.begin() - 1)];
}

double quantile(const Distribution& distribution, double share) {
  if (distribution.value.empty()) return unknown;
  const auto at = std::lower_bound(distribution.below.begin(), distribution.below.end(), share);
  return distribution.value[static_cast<std::size_t>(std::min(at, distribution.below.end() - 1) -
                                                     distribution.below.begin())];
}

DistributionDistance distance_between(const Distribution& first, const Distribution& second) {
  if (first.value.empty() || second.value.empty()) return {unknown, unknown};
  DistributionDistance distance;
  double f = 0, g = 0, last = 0;
  for (std::size_t i = 0, j = 0; i < first.value.size() || j < second.value.size();) {
    const double in_first = i < first.value.size() ? first.value[i] : infinite;
    const double in_second = j < second.value.size() ? second.value[j] : infinite;
    const double next = std::min(in_first, in_second);
    distance.mean += std::abs(f - g) * (next - last);
    if (in_first <= next) f = first.below[i++];
    if (in_second <= next) g = second.below[j++];
    distance.largest = std::max(distance.largest, std::abs(f - g));
    last = next;
  }
  return distance;
}

}  // namespace specimen
