#include "specimen/aggregate_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "specimen/plane.hpp"
#include "specimen/spatial_grid.hpp"

namespace specimen {
namespace {

constexpr double telling_nothing = 0.75;  // share of cut aggregates

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
  sample.with_parts = sample.cut_share > telling_nothing;
  if (sample.with_parts) sample.aggregates.insert(sample.aggregates.end(), parts.begin(), parts.end());
  if (sample.cut == 0 || sample.with_parts)
    for (SampledAggregate& one : sample.aggregates) one.weight = 1;
  std::stable_sort(sample.aggregates.begin(), sample.aggregates.end(),
                   [](const auto& p, const auto& q) { return p.diameter > q.diameter; });
  return sample;
}

SizeCurve size_curve(const std::vector<const AggregateSample*>& samples) {
  std::vector<std::pair<double, double>> shares;  // of the area, by diameter
  double whole = 0;
  for (const AggregateSample* sample : samples) {
    double area = 0;
    for (const SampledAggregate& one : sample->aggregates) area += one.weighted_area();
    for (const SampledAggregate& one : sample->aggregates)
      shares.emplace_back(one.diameter, one.weighted_area() / area);
    if (area > 0) ++whole;
  }
  std::sort(shares.begin(), shares.end());
  SizeCurve curve;
  double below = 0;
  for (const auto& [diameter, share] : shares) {
    below += share / whole;
    if (!curve.diameter.empty() && curve.diameter.back() == diameter) {
      curve.below.back() = below;
    } else {
      curve.diameter.push_back(diameter);
      curve.below.push_back(below);
    }
  }
  if (!curve.below.empty()) curve.below.back() = 1;
  return curve;
}

double diameter_at(const SizeCurve& curve, double share) {
  if (curve.diameter.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = std::lower_bound(curve.below.begin(), curve.below.end(), share);
  return curve.diameter[static_cast<std::size_t>(std::min(at, curve.below.end() - 1) - curve.below.begin())];
}

SizeDistance distance_between(const SizeCurve& first, const SizeCurve& second) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (first.diameter.empty() || second.diameter.empty()) return {unknown, unknown};
  SizeDistance distance;
  double f = 0, g = 0, last = 0;
  for (std::size_t i = 0, j = 0; i < first.diameter.size() || j < second.diameter.size();) {
    const double in_first = i < first.diameter.size() ? first.diameter[i] : infinite;
    const double in_second = j < second.diameter.size() ? second.diameter[j] : infinite;
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
