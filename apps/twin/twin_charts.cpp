#include "apps/twin/twin_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace app {
namespace {

using output::Chart;
using output::Ink;
using output::Series;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;

/// Values of every twin at the same abscissas, put together.
struct Band {
  Values mean, least, largest;
};

Band band_of(const std::vector<Values>& twins) {
  std::size_t count = twins.front().size();
  for (const Values& twin : twins) count = std::min(count, twin.size());
  Band band;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0, least = twins.front()[i], largest = least;
    for (const Values& twin : twins) {
      sum += twin[i];
      least = std::min(least, twin[i]);
      largest = std::max(largest, twin[i]);
    }
    band.mean.push_back(sum / static_cast<double>(twins.size()));
    band.least.push_back(least);
    band.largest.push_back(largest);
  }
  return band;
}

/// Adds a line of points that begins anew after what is there.
void add_line(Series& series, const Values& x, const Values& y) {
  if (!series.x.empty()) {
    series.x.push_back(gap);
    series.y.push_back(gap);
  }
  const std::size_t count = std::min(x.size(), y.size());
  series.x.insert(series.x.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count));
  series.y.insert(series.y.end(), y.begin(), y.begin() + static_cast<std::ptrdiff_t>(count));
}

Series line(const std::string& name, const Values& x, const Values& y, Ink ink, bool dashed = false) {
  Series series{name, {}, {}, ink, dashed};
  add_line(series, x, y);
  return series;
}

/// @param of  values of one specimen at the abscissas x.
void add_original_and_twins(Chart& chart, const Values& x, const TwinTask& task,
                            const std::vector<TwinRecord>& twins,
                            const std::function<Values(const specimen::Descriptors&)>& of) {
  std::vector<Values> all;
  for (const TwinRecord& twin : twins) all.push_back(of(twin.descriptors));
  const Band band = band_of(all);
  if (twins.size() > 1) {
    Series range = line("twins, least and largest", x, band.least, Ink::muted);
    add_line(range, x, band.largest);
    chart.series.push_back(std::move(range));
  }
  chart.series.push_back(line("twins, mean", x, band.mean, Ink::second, true));
  chart.series.push_back(line("original", x, of(task.descriptors), Ink::first));
}

/// Corners of the bars of a histogram.
Values edges_twice(const Values& edges) {
  Values x;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) x.insert(x.end(), {edges[i], edges[i + 1]});
  return x;
}

/// Share of the area [%] per bar, each twice, for its two corners.
Values histogram(const specimen::Descriptors& descriptors, const Values& edges,
                 double (*figure)(const specimen::SampledAggregate&)) {
  Values heights(2 * (edges.size() - 1), 0);
  double whole = 0;
  for (const auto& one : descriptors.sample.aggregates) whole += one.weighted_area();
  for (const auto& one : descriptors.sample.aggregates) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), figure(one)) - edges.begin();
    const auto bar =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(edges) - 2));
    heights[2 * bar] += 100 * one.weighted_area() / whole;
    heights[2 * bar + 1] = heights[2 * bar];
  }
  return heights;
}

Values evenly(double from, double to, int parts) {
  Values values;
  for (int i = 0; i <= parts; ++i) values.push_back(from + (to - from) * i / parts);
  return values;
}

Values times(Values values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

double largest_diameter(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  double largest = task.descriptors.sample.aggregates.front().diameter;
  for (const TwinRecord& twin : twins)
    for (const auto& one : twin.descriptors.sample.aggregates) largest = std::max(largest, one.diameter);
  return largest;
}

/// Beyond it lie but a few of the distances to nearest neighbours.
double last_gap_shown(const specimen::Descriptors& d) {
  return d.gaps.empty() ? d.pixel_size : d.gaps[(d.gaps.size() - 1) * 19 / 20] + d.pixel_size;
}

Values s2_of(const specimen::TwoPoint& s2, Values specimen::TwoPoint::*curve, const Values& distances) {
  return specimen::at_distances(s2.distance, s2.*curve, distances);
}

}  // namespace

Chart size_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Size curves", {"Diameter", "mm"}, {"Passing, by area", "%"}, {}, {}};
  const Values diameters = evenly(0, 1.02 * largest_diameter(task, twins), 120);
  add_original_and_twins(chart, times(diameters, 1e3), task, twins, [&](const specimen::Descriptors& d) {
    const specimen::Distribution sizes = specimen::distribution_of(specimen::sizes_by_area(d.sample));
    Values shares;
    for (const double diameter : diameters) shares.push_back(100 * share_up_to(sizes, diameter));
    return shares;
  });
  return chart;
}

Chart aspect_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Aspect ratios", {"Short over long axis", ""}, {"Share of the area", "%"}, {}, {}};
  const Values edges = evenly(0, 1, 10);
  add_original_and_twins(chart, edges_twice(edges), task, twins, [&](const specimen::Descriptors& d) {
    return histogram(d, edges, [](const specimen::SampledAggregate& one) { return one.aspect; });
  });
  return chart;
}

Chart direction_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Directions", {"Long axis against x", "degrees"}, {"Share of the area", "%"}, {}, {}};
  const Values edges = evenly(0, 180, 9);
  add_original_and_twins(chart, edges_twice(edges), task, twins, [&](const specimen::Descriptors& d) {
    return histogram(
        d, edges, [](const specimen::SampledAggregate& one) { return one.angle * 180 / std::numbers::pi; });
  });
  return chart;
}

Chart gap_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Nearest neighbours", {"Distance", "mm"}, {"Aggregates that have one", "%"}, {}, {}};
  double largest = last_gap_shown(task.descriptors);
  for (const TwinRecord& twin : twins) largest = std::max(largest, last_gap_shown(twin.descriptors));
  const Values distances = evenly(0, largest, 120);
  add_original_and_twins(chart, times(distances, 1e3), task, twins, [&](const specimen::Descriptors& d) {
    Values shares;
    for (const double distance : distances) {
      const auto near = std::upper_bound(d.gaps.begin(), d.gaps.end(), distance) - d.gaps.begin();
      shares.push_back(d.gaps.empty() ? gap
                                      : 100 * static_cast<double>(near) / static_cast<double>(d.gaps.size()));
    }
    return shares;
  });
  return chart;
}

Chart s2_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Two-point probability", {"Distance", "mm"}, {"S2", ""}, {}, {}};
  const Values& distances = task.descriptors.s2.distance;
  add_original_and_twins(chart, times(distances, 1e3), task, twins, [&](const specimen::Descriptors& d) {
    return s2_of(d.s2, &specimen::TwoPoint::radial, distances);
  });
  const double square = task.descriptors.fraction * task.descriptors.fraction;
  chart.series.push_back(
      line("fraction squared", {0, 1e3 * distances.back()}, {square, square}, Ink::text, true));
  return chart;
}

Chart s2_along_axes_chart(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  Chart chart{"Two-point probability along x and y", {"Distance", "mm"}, {"S2", ""}, {}, {}};
  const Values& distances = task.descriptors.s2.distance;
  const Values x = times(distances, 1e3);
  const auto add = [&](const std::string& axis, Values specimen::TwoPoint::*curve, Ink ink) {
    std::vector<Values> all;
    for (const TwinRecord& twin : twins) all.push_back(s2_of(twin.descriptors.s2, curve, distances));
    chart.series.push_back(line("original, " + axis, x, task.descriptors.s2.*curve, ink));
    chart.series.push_back(line("twins, " + axis, x, band_of(all).mean, ink, true));
  };
  add("along x", &specimen::TwoPoint::along_x, Ink::first);
  add("along y", &specimen::TwoPoint::along_y, Ink::second);
  return chart;
}

}  // namespace app
