#include "specimen/describe/aggregate_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "specimen/body/mask.hpp"
#include "specimen/pack/placement.hpp"

namespace specimen {
namespace {}  // namespace

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
  if (distribution.value.empty()) return not_known;
  const auto at = std::lower_bound(distribution.below.begin(), distribution.below.end(), share);
  return distribution.value[static_cast<std::size_t>(std::min(at, distribution.below.end() - 1) -
                                                     distribution.below.begin())];
}

DistributionDistance distance_between(const Distribution& first, const Distribution& second) {
  if (first.value.empty() || second.value.empty()) return {not_known, not_known};
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

namespace {

Box box_of(const Inclusion& inclusion) {
  if (inclusion.contour.empty()) return box_round(body_of(inclusion.ellipse), 0);
  Box box{infinite, infinite, -infinite, -infinite};
  for (const Point p : inclusion.contour) {
    box.left = std::min(box.left, p.x);
    box.right = std::max(box.right, p.x);
    box.bottom = std::min(box.bottom, p.y);
    box.top = std::max(box.top, p.y);
  }
  return box;
}

// Share of the places of a box at which it lies in the window; for one as wide as the window, of the places
// that pixels tell apart.
double chance_to_be_whole(const Box& box, const LabelledMask& mask) {
  const double width = mask.width(), height = mask.height(), d = mask.pixel_size;
  const double across = std::max(d, width - (box.right - box.left));
  const double up = std::max(d, height - (box.top - box.bottom));
  return across * up / (width * height);
}

SampledAggregate sampled(const Inclusion& inclusion, double weight) {
  return {inclusion.equivalent_diameter, inclusion.ellipse.b / inclusion.ellipse.a, inclusion.orientation,
          weight};
}

}  // namespace

double SampledAggregate::area() const { return std::numbers::pi / 4 * diameter * diameter; }

double SampledAggregate::weighted_area() const { return weight * area(); }

bool is_cut(const Inclusion& inclusion, const LabelledMask& mask) {
  const Box box = box_of(inclusion);
  const double near = 1e-6 * mask.pixel_size;
  return box.left <= near || box.bottom <= near || box.right >= mask.width() - near ||
         box.top >= mask.height() - near;
}

AggregateSample sample_aggregates(const Specimen& specimen) {
  AggregateSample sample;
  double whole_area = 0, cut_area = 0;
  std::vector<SampledAggregate> parts;
  for (const Inclusion& inclusion : specimen.inclusions) {
    if (is_cut(inclusion, specimen.mask)) {
      parts.push_back(sampled(inclusion, 1));
      cut_area += inclusion.area;
    } else {
      const double chance = chance_to_be_whole(box_of(inclusion), specimen.mask);
      sample.aggregates.push_back(sampled(inclusion, 1 / chance));
      whole_area += inclusion.area;
    }
  }
  sample.cut = static_cast<int>(parts.size());
  if (sample.cut > 0) sample.cut_share = cut_area / (cut_area + whole_area);
  if (sample.cut == 0)
    for (SampledAggregate& one : sample.aggregates) one.weight = 1;
  double largest = 0;
  for (const SampledAggregate& one : sample.aggregates) largest = std::max(largest, one.diameter);
  for (const SampledAggregate& part : parts) {
    if (part.diameter <= largest) continue;
    sample.aggregates.push_back(part);
    ++sample.parts;
  }
  std::stable_sort(sample.aggregates.begin(), sample.aggregates.end(),
                   [](const auto& p, const auto& q) { return p.diameter > q.diameter; });
  return sample;
}

std::vector<WeightedValue> sizes_by_area(const AggregateSample& sample) {
  std::vector<WeightedValue> sizes;
  for (const SampledAggregate& one : sample.aggregates) sizes.push_back({one.diameter, one.weighted_area()});
  return sizes;
}

}  // namespace specimen
