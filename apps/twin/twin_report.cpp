#include "apps/twin/twin_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "apps/twin/twin_words.hpp"
#include "specimen/describe/doubts.hpp"
#include "specimen/picture/picture.hpp"

namespace app {
namespace {

using output::Chart;
using output::Ink;
using output::Series;

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

Series line(const std::string& name, const Values& x, const Values& y, Ink ink, bool dashed = false) {
  Series series{name, {}, {}, ink, dashed};
  output::add_line(series, x, y);
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
    output::add_line(range, x, band.largest);
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
      shares.push_back(d.gaps.empty() ? output::gap
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

namespace {

using output::escape;
using output::section;

std::string figure(const specimen::Raster<specimen::Rgb>& picture, const std::string& name,
                   const specimen::Descriptors& d) {
  return fmt::format(
      "<figure>\n{}<figcaption><b>{}</b><br/>{} aggregate, {} whole and {} cut</figcaption>\n</figure>\n",
      output::image(picture, name, ""), escape(name), output::percent(d.fraction), d.sample.whole(),
      d.sample.cut);
}

std::string pictures(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  using specimen::phase_colour;
  namespace phase = specimen::phase;
  std::string html = figure(specimen::preview(task.original.mask), "The original", task.descriptors);
  for (const TwinRecord& twin : twins)
    if (!twin.picture.empty())
      html += figure(twin.picture, fmt::format("Twin of seed {}", twin.seed), twin.descriptors);
  return output::legend("", {{phase_colour(phase::aggregate), "aggregate"},
                             {phase_colour(phase::mortar), "mortar"},
                             {phase_colour(phase::itz), "ITZ"},
                             {phase_colour(phase::void_), "void"}}) +
         output::pictures(html);
}

std::string figures_table(const TwinTask& task, const specimen::Misfit& misfit) {
  std::vector<std::vector<std::string>> rows;
  for (const FigureRow& row : figure_rows(task, misfit))
    rows.push_back({row.name, row.original, row.mean, row.deviation, row.range, row.difference});
  return output::number_table(
      {"Figure", "Original", "Twins, mean", "Standard deviation", "Twins, range", "Off by"}, rows);
}

std::string curves_table(const specimen::Misfit& misfit) {
  std::vector<std::vector<std::string>> rows;
  for (const CurveRow& row : curve_rows(misfit))
    rows.push_back({row.name, row.original, row.mean, row.largest, row.verdict});
  return output::number_table({"Difference from the mean of the (other) twins", "Original", "A twin, mean",
                               "Farthest twin", "The original is"},
                              rows);
}

std::string sentences(std::vector<std::string> notes) {
  for (std::string& note : notes) note = output::capitalised(note) + ".";
  return output::notes_list(notes);
}

constexpr const char* s2_caption =
    "Probability that both ends of a segment lie in aggregate, in the mean over all directions.";
constexpr const char* s2_axes_caption =
    "The same along x and along y; they part where aggregates have a direction.";
constexpr const char* size_caption = "Area of aggregates up to a diameter, the circle of the same area.";
constexpr const char* aspect_caption = "Of the ellipses of the same area and second moments.";
constexpr const char* gap_caption =
    "From the outline of each aggregate to the nearest outline of another one.";
constexpr const char* direction_caption = "Counter-clockwise from the horizontal.";
constexpr const char* figure_words =
    "Fraction, sizes, aspect ratios and, where there are any, directions are drawn from the original; places "
    "are "
    "random.";
constexpr const char* curve_words =
    "Differences of S2 are in per cent of fraction (1 - fraction). An original that is not farther off than "
    "the "
    "farthest twin may be one of them, as far as that curve tells.";

}  // namespace

std::string twin_html(const TwinTask& task, const std::vector<TwinRecord>& twins,
                      const specimen::Misfit& misfit, const std::vector<std::string>& notes) {
  using output::chart_figure;
  using output::side_by_side;
  const std::string title = "Twins of " + task.name;
  const auto standing = [](const char* heading, const auto& make) {
    return output::standing(heading, [&] { return section(heading, make()); });
  };
  const auto match = [&] {
    return output::paragraph(figure_words) + figures_table(task, misfit) + output::paragraph(curve_words) +
           curves_table(misfit);
  };
  const auto places = [&] {
    return side_by_side("even", chart_figure(s2_chart(task, twins), 500, 330, s2_caption),
                        chart_figure(s2_along_axes_chart(task, twins), 500, 330, s2_axes_caption));
  };
  const auto shapes = [&] {
    return output::in_pairs({chart_figure(size_chart(task, twins), 500, 330, size_caption),
                             chart_figure(aspect_chart(task, twins), 500, 330, aspect_caption),
                             chart_figure(direction_chart(task, twins), 500, 330, direction_caption),
                             chart_figure(gap_chart(task, twins), 500, 330, gap_caption)});
  };
  return output::page(
      title, output::heading(title, twins_text(task, twins.size())) +
                 output::warnings_section(specimen::doubts_of(task.original)) +
                 standing("The original and its twins", [&] { return pictures(task, twins); }) +
                 standing("How well they match", match) + standing("Where aggregate is", places) +
                 standing("Sizes and shapes", shapes) + section("How it was made", sentences(notes)));
}

}  // namespace app
