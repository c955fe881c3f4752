#include "specimen/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace specimen {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Figure = std::function<double(const Descriptors&)>;

FigureMisfit compare_figure(const Descriptors& original, const std::vector<Descriptors>& twins,
                            const Figure& figure) {
  FigureMisfit misfit{figure(original), 0, 0, figure(twins.front()), figure(twins.front())};
  const auto count = static_cast<double>(twins.size());
  for (const Descriptors& twin : twins) {
    misfit.mean += figure(twin) / count;
    misfit.least = std::min(misfit.least, figure(twin));
    misfit.largest = std::max(misfit.largest, figure(twin));
  }
  if (twins.size() < 2) return misfit;
  for (const Descriptors& twin : twins)
    misfit.deviation += std::pow(figure(twin) - misfit.mean, 2) / (count - 1);
  misfit.deviation = std::sqrt(misfit.deviation);
  return misfit;
}

// Distance from one specimen to the mean of some twins.
using Distance = std::function<double(const Descriptors& one, const std::vector<const Descriptors*>& others)>;

CurveMisfit compare_curve(const Descriptors& original, const std::vector<Descriptors>& twins,
                          const Distance& distance) {
  std::vector<const Descriptors*> all;
  for (const Descriptors& twin : twins) all.push_back(&twin);
  CurveMisfit misfit{distance(original, all), unknown, unknown};
  if (twins.size() < 2) return misfit;
  misfit.mean = misfit.largest = 0;
  for (std::size_t i = 0; i < twins.size(); ++i) {
    std::vector<const Descriptors*> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const double own = distance(twins[i], others);
    misfit.mean += own / static_cast<double>(twins.size());
    misfit.largest = std::max(misfit.largest, own);
  }
  return misfit;
}

SizeDistance size_distance(const Descriptors& one, const std::vector<const Descriptors*>& others) {
  std::vector<const AggregateSample*> samples;
  for (const Descriptors* other : others) samples.push_back(&other->sample);
  return distance_between(size_curve({&one.sample}), size_curve(samples));
}

using Curve = std::vector<double> TwoPoint::*;

// Differences of S2 from the mean of the others at the distances of the original, over `scale`.
std::vector<double> s2_differences(const Descriptors& one, const std::vector<const Descriptors*>& others,
                                   Curve curve, const std::vector<double>& distances, double scale) {
  const auto values_of = [&](const Descriptors& d) {
    return at_distances(d.s2.distance, d.s2.*curve, distances);
  };
  std::vector<double> differences = values_of(one);
  for (const Descriptors* other : others) {
    const std::vector<double> theirs = values_of(*other);
    differences.resize(std::min(differences.size(), theirs.size()));
    for (std::size_t i = 0; i < differences.size(); ++i)
      differences[i] -= theirs[i] / static_cast<double>(others.size());
  }
  for (double& difference : differences) difference /= scale;
  return differences;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double mean_direction(const std::vector<Descriptors>& twins) {
  std::vector<WeightedAxis> axes;
  for (const Descriptors& twin : twins)
    axes.push_back({twin.orientation.direction, twin.orientation.strength});
  return mean_orientation(axes).direction;
}

}  // namespace

std::vector<double> at_distances(const std::vector<double>& distance, const std::vector<double>& values,
                                 const std::vector<double>& wanted) {
  std::vector<double> result;
  if (distance.empty()) return result;
  const double near = 1e-9 * distance.back();
  std::size_t i = 0;
  for (const double at : wanted) {
    if (at > distance.back() + near) break;
    while (i + 1 < distance.size() && distance[i + 1] < at - near) ++i;
    const std::size_t next = std::min(i + 1, distance.size() - 1);
    const double step = distance[next] - distance[i];
    const double share = step > 0 ? std::clamp((at - distance[i]) / step, 0.0, 1.0) : 0;
    result.push_back((1 - share) * values[i] + share * values[next]);
  }
  return result;
}

Misfit compare(const Descriptors& original, const std::vector<Descriptors>& twins) {
  const double scale = original.fraction * (1 - original.fraction);
  const auto figure = [&](const Figure& of) { return compare_figure(original, twins, of); };
  const auto s2 = [&](Curve curve, double (*summary)(const std::vector<double>&)) {
    return compare_curve(original, twins, [&](const Descriptors& one, const auto& others) {
      return summary(s2_differences(one, others, curve, original.s2.distance, scale));
    });
  };
  Misfit misfit;
  misfit.fraction = figure([](const Descriptors& d) { return d.fraction; });
  misfit.median_diameter = figure([](const Descriptors& d) { return d.median_diameter; });
  misfit.mean_aspect = figure([](const Descriptors& d) { return d.mean_aspect; });
  misfit.strength = figure([](const Descriptors& d) { return d.orientation.strength; });
  misfit.mean_gap = figure([](const Descriptors& d) { return d.mean_gap; });
  misfit.specific_perimeter = figure([](const Descriptors& d) { return d.specific_perimeter; });
  misfit.direction = mean_direction(twins);
  misfit.sizes = compare_curve(original, twins, [](const Descriptors& one, const auto& others) {
    return size_distance(one, others).largest;
  });
  misfit.sizes_mean = compare_curve(original, twins, [](const Descriptors& one, const auto& others) {
    return size_distance(one, others).mean;
  });
  misfit.s2_rms = s2(&TwoPoint::radial, root_mean_square);
  misfit.s2_largest = s2(&TwoPoint::radial, largest_of);
  misfit.s2_along_x_rms = s2(&TwoPoint::along_x, root_mean_square);
  misfit.s2_along_y_rms = s2(&TwoPoint::along_y, root_mean_square);
  return misfit;
}

}  // namespace specimen
