#include "specimen/describe/descriptors.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "specimen/describe/spacing.hpp"

namespace specimen {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double mean_aspect(const AggregateSample& sample) {
  double sum = 0, area = 0;
  for (const SampledAggregate& one : sample.aggregates) {
    sum += one.aspect * one.weighted_area();
    area += one.weighted_area();
  }
  return area > 0 ? sum / area : unknown;
}

Orientation orientation_of(const AggregateSample& sample) {
  std::vector<WeightedAxis> axes;
  for (const SampledAggregate& one : sample.aggregates) axes.push_back({one.angle, one.weighted_area()});
  return mean_orientation(axes);
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return unknown;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Descriptors describe(const Specimen& specimen) {
  const LabelledMask& mask = specimen.mask;
  const std::vector<double> shares = fractions(mask);
  Descriptors d;
  d.width = mask.width();
  d.height = mask.height();
  d.pixel_size = mask.pixel_size;
  d.fraction = shares[phase::aggregate];
  d.void_fraction = shares[phase::void_];
  d.specific_perimeter = perimeter(mask, phase::aggregate) / (d.width * d.height);
  d.sample = sample_aggregates(specimen);
  d.median_diameter = quantile(distribution_of(sizes_by_area(d.sample)), 0.5);
  d.mean_aspect = mean_aspect(d.sample);
  d.orientation = orientation_of(d.sample);
  d.gaps = nearest_gaps(specimen);
  std::sort(d.gaps.begin(), d.gaps.end());
  d.mean_gap = mean(d.gaps);
  d.merged = static_cast<int>(
      std::count_if(specimen.inclusions.begin(), specimen.inclusions.end(),
                    [](const Inclusion& inclusion) { return solidity(inclusion) < least_solidity; }));
  d.s2 = two_point_correlation(mask, phase::aggregate);
  return d;
}

}  // namespace specimen
