#include "specimen/describe/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace specimen {
namespace {

using Figure = std::function<double(const Descriptors&)>;

FigureMisfit compare_figure(const Descriptors& original, const std::vector<Descriptors>& twins,
                            const Figure& figure) {
  FigureMisfit misfit{figure(original), 0, not_known, figure(twins.front()), figure(twins.front())};
  const auto count = static_cast<double>(twins.size());
  for (const Descriptors& twin : twins) {
    misfit.mean += figure(twin) / count;
    misfit.least = std::min(misfit.least, figure(twin));
    misfit.largest = std::max(misfit.largest, figure(twin));
  }
  if (twins.size() < 2) return misfit;
  misfit.deviation = 0;
  for (const Descriptors& twin : twins)
    misfit.deviation += std::pow(figure(twin) - misfit.mean, 2) / (count - 1);
  misfit.deviation = std::sqrt(misfit.deviation);
  return misfit;
}

// Distances from the mean of the (other) twins, of the original first, then of each twin.
CurveMisfit misfit_of(const std::vector<double>& distances) {
  CurveMisfit misfit{distances.front(), not_known, not_known};
  const std::size_t twins = distances.size() - 1;
  if (twins < 2) return misfit;
  misfit.mean = misfit.largest = 0;
  for (std::size_t i = 1; i <= twins; ++i) {
    misfit.mean += distances[i] / static_cast<double>(twins);
    misfit.largest = std::max(misfit.largest, distances[i]);
  }
  return misfit;
}

using Sample = std::vector<WeightedValue>;

// Distances of distributions, of the original first, then of each twin.
struct Distances {
  std::vector<double> largest, mean;
};

Distances distances_of(const Descriptors& original, const std::vector<Descriptors>& twins,
                       Sample (*sample)(const Descriptors&)) {
  std::vector<Sample> samples;
  for (const Descriptors& twin : twins) samples.push_back(sample(twin));
  const PooledDistribution pool(samples);
  Distances distances;
  const auto add = [&distances](const Sample& one, const Distribution& others) {
    const DistributionDistance distance = distance_between(distribution_of(one), others);
    distances.largest.push_back(distance.largest);
    distances.mean.push_back(distance.mean);
  };
  add(sample(original), pool.all());
  for (std::size_t i = 0; i < twins.size(); ++i) add(samples[i], pool.without(i));
  return distances;
}

using Curve = std::vector<double> TwoPoint::*;

// Curves of S2 at the distances of the original, as far as all have them; of the original first.
std::vector<std::vector<double>> s2_curves(const Descriptors& original, const std::vector<Descriptors>& twins,
                                           Curve curve) {
  std::vector<std::vector<double>> curves{original.s2.*curve};
  std::size_t common = curves.front().size();
  for (const Descriptors& twin : twins) {
    curves.push_back(at_distances(twin.s2.distance, twin.s2.*curve, original.s2.distance));
    common = std::min(common, curves.back().size());
  }
  for (std::vector<double>& values : curves) values.resize(common);
  return curves;
}

// Differences of each curve from the mean of the (other) twins.
std::vector<std::vector<double>> differences_of(std::vector<std::vector<double>> curves) {
  const auto twins = static_cast<double>(curves.size() - 1);
  for (std::size_t at = 0; at < curves.front().size(); ++at) {
    double sum = 0;
    for (std::size_t i = 1; i < curves.size(); ++i) sum += curves[i][at];
    curves[0][at] -= sum / twins;
    for (std::size_t i = 1; i < curves.size(); ++i) curves[i][at] -= (sum - curves[i][at]) / (twins - 1);
  }
  return curves;
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
    std::vector<double> distances;
    for (const auto& differences : differences_of(s2_curves(original, twins, curve)))
      distances.push_back(summary(differences) / scale);
    return misfit_of(distances);
  };
  Misfit misfit;
  misfit.fraction = figure([](const Descriptors& d) { return d.fraction; });
  misfit.median_diameter = figure([](const Descriptors& d) { return d.median_diameter; });
  misfit.mean_aspect = figure([](const Descriptors& d) { return d.mean_aspect; });
  misfit.strength = figure([](const Descriptors& d) { return d.orientation.strength; });
  misfit.mean_gap = figure([](const Descriptors& d) { return d.mean_gap; });
  misfit.specific_perimeter = figure([](const Descriptors& d) { return d.specific_perimeter; });
  misfit.direction = mean_direction(twins);
  const Distances sizes =
      distances_of(original, twins, [](const Descriptors& d) { return sizes_by_area(d.sample); });
  misfit.sizes = misfit_of(sizes.largest);
  misfit.sizes_mean = misfit_of(sizes.mean);
  const Distances gaps = distances_of(original, twins, [](const Descriptors& d) {
    Sample sample;
    for (const double gap : d.gaps) sample.push_back({gap, 1});
    return sample;
  });
  misfit.gaps = misfit_of(gaps.largest);
  misfit.s2_rms = s2(&TwoPoint::radial, root_mean_square);
  misfit.s2_largest = s2(&TwoPoint::radial, largest_of);
  misfit.s2_along_x_rms = s2(&TwoPoint::along_x, root_mean_square);
  misfit.s2_along_y_rms = s2(&TwoPoint::along_y, root_mean_square);
  return misfit;
}

}  // namespace specimen
