#include "apps/study/study_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/stress_drawing.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/statistics/statistics.hpp"

namespace app {
namespace {

using output::Chart;
using output::Ink;
using output::Series;

using output::gap;
constexpr double normal_95 =
    1.96;  ///< a normal variable is within so many standard errors in 95 of 100 cases
constexpr std::size_t most_lines = 200;  ///< faint curves in a chart
constexpr int places = 201;              ///< of a band along its axis

/// Dots without a line.
Series dots(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, Ink ink) {
  Series series{name, {}, {}, ink, false, true};
  for (std::size_t i = 0; i < x.size(); ++i) {
    series.x.insert(series.x.end(), {x[i], gap});
    series.y.insert(series.y.end(), {y[i], gap});
  }
  return series;
}

/// Source of the number of bins: Freedman and Diaconis (1981), at least five and at most fifty.
int bins_of(const std::vector<double>& values, double low, double high) {
  const double range = quantile_of(values, 0.75) - quantile_of(values, 0.25);
  const double width = 2 * range / std::cbrt(static_cast<double>(values.size()));
  const double bins = width > 0 ? std::ceil((high - low) / width) : 0;
  return static_cast<int>(std::clamp(bins, 5.0, 50.0));
}

double last_strain(const std::vector<std::vector<Curve>>& groups) {
  double last = 0;
  for (const auto& group : groups)
    for (const Curve& curve : group)
      if (!curve.strain.empty()) last = std::max(last, curve.strain.back());
  return last;
}

/// So many curves that they can be told apart, evenly from all of them.
Series faint(const std::vector<std::vector<Curve>>& groups, double per_strain) {
  std::vector<const Curve*> all;
  for (const auto& group : groups)
    for (const Curve& curve : group)
      if (!curve.strain.empty()) all.push_back(&curve);
  const std::size_t shown = std::min(all.size(), most_lines);
  Series series{
      shown < all.size() ? fmt::format("{} of {} members", shown, all.size()) : "members", {}, {}, Ink::grid};
  for (std::size_t i = 0; i < shown; ++i) {
    const Curve& curve = *all[i * all.size() / shown];
    output::add_line(series, curve.strain, curve.stress, per_strain, 1e-6);
  }
  return series;
}

std::vector<Curve> not_empty(const std::vector<Curve>& curves) {
  std::vector<Curve> found;
  std::copy_if(curves.begin(), curves.end(), std::back_inserter(found),
               [](const Curve& curve) { return !curve.strain.empty(); });
  return found;
}

Series line_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, Ink ink,
               bool dashed, double per_strain) {
  Series series{name, {}, {}, ink, dashed};
  output::add_line(series, x, y, per_strain, 1e-6);
  return series;
}

/// log(-log(1 - p)), which is straight in the logarithm of the value.
double paper(double p) { return std::log(-std::log1p(-p)); }

}  // namespace

Chart histogram_chart(const std::vector<double>& values, const std::string& name, const std::string& unit) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double low = *least, high = *largest > *least ? *largest : *least + std::abs(*least) + 1;
  const int bins = bins_of(values, low, high);
  std::vector<double> shifted;
  for (const double value : values) shifted.push_back(value - low);
  const double end = (high - low) * (1 + 1e-9);  // the largest value has a bin too
  const std::vector<double> density = histogram(shifted, end, bins);
  Series series{"", {low}, {0}, Ink::first};
  const double width = end / bins, members = width * static_cast<double>(values.size());
  for (int i = 0; i < bins; ++i) {
    const double count = density[static_cast<std::size_t>(i)] * members;
    series.x.insert(series.x.end(), {low + i * width, low + (i + 1) * width});
    series.y.insert(series.y.end(), {count, count});
  }
  series.x.push_back(low + end);
  series.y.push_back(0);
  return {"How often each " + name + " came out", {name, unit, false, true}, {"Members", ""}, {series}, {}};
}

Chart weibull_chart(const std::vector<double>& values, const WeibullFit& fit, const std::string& name,
                    const std::string& unit) {
  std::vector<double> sorted = values, heights;
  std::sort(sorted.begin(), sorted.end());
  const auto count = static_cast<double>(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    heights.push_back(paper((static_cast<double>(i) + 0.5) / count));
  Series line{"Weibull distribution", {}, {}, Ink::first},
      low{"95 % confidence band", {}, {}, Ink::first, true}, high{"", {}, {}, Ink::first, true};
  const double first = heights.front() - 0.7, last = heights.back() + 0.4;
  for (int i = 0; i <= 60; ++i) {
    const double height = first + (last - first) * i / 60;
    const double p = -std::expm1(-std::exp(height));
    const double value = fit.quantile(p), factor = std::exp(normal_95 * fit.log_error(p));
    for (const auto& [series, x] :
         {std::pair(&line, value), {&low, value / factor}, {&high, value * factor}}) {
      series->x.push_back(x);
      series->y.push_back(height);
    }
  }
  return {"Weibull plot of the " + name,
          {name, unit, true},
          {"ln(-ln(1 - share of members))", ""},
          {dots("members", sorted, heights, Ink::text), line, low, high},
          {}};
}

Chart convergence_chart(const std::vector<double>& values, const std::string& name, const std::string& unit) {
  Series mean{"mean of the first members", {}, {}, Ink::first};
  Series low{"95 % confidence interval", {}, {}, Ink::first, true}, high{"", {}, {}, Ink::first, true};
  std::vector<double> so_far;
  for (const double value : finite_of(values)) {
    so_far.push_back(value);
    if (so_far.size() < 3) continue;  // the interval of two values dwarfs all others
    const MeanEstimate estimate = mean_estimate(so_far);
    for (const auto& [series, y] : {std::pair(&mean, estimate.mean),
                                    {&low, estimate.mean - estimate.half_width},
                                    {&high, estimate.mean + estimate.half_width}}) {
      series->x.push_back(static_cast<double>(so_far.size()));
      series->y.push_back(y);
    }
  }
  return {"Mean " + name + " against the number of members",
          {"Members", "", false, true},
          {name, unit, false, true},
          {mean, low, high},
          {}};
}

Chart curves_chart(const std::vector<std::string>& names, const std::vector<std::vector<Curve>>& groups,
                   const std::string& stress_name, const std::string& strain_name) {
  const double last = last_strain(groups);
  const output::StrainUnit unit = output::strain_unit(last);
  Chart chart{"Stress against strain of all members", {strain_name, unit.name}, {stress_name, "MPa"}, {}, {}};
  chart.series.push_back(faint(groups, unit.per_strain));
  const std::vector<double> axis = even_axis(last, places);
  for (std::size_t i = 0; i < std::min(groups.size(), output::series_inks); ++i) {
    const CurveBand band = band_of(not_empty(groups[i]), axis, 0.1);
    const auto add = [&](const std::string& name, const std::vector<double>& y, bool dashed) {
      chart.series.push_back(line_of(name, band.x, y, output::ink_of_series(i), dashed, unit.per_strain));
    };
    add(names[i], band.mean, false);
    if (groups.size() > 1) continue;
    add("middle 80 %", band.low, true);
    add("", band.high, true);
  }
  return chart;
}

Chart size_chart(const std::vector<double>& sizes, const std::vector<double>& strengths,
                 const SizeEffect& fit) {
  std::vector<double> x, y;
  for (const double size : sizes) x.push_back(1e3 * size);
  for (const double strength : strengths) y.push_back(1e-6 * strength);
  const auto [least, largest] = std::minmax_element(sizes.begin(), sizes.end());
  Series law{"law of the size effect", {}, {}, Ink::first};
  for (int i = 0; i <= 60; ++i) {
    const double size = *least * std::pow(*largest / *least, i / 60.0);
    law.x.push_back(1e3 * size);
    law.y.push_back(1e-6 * fit.strength(size));
  }
  return {"Strength against size",
          {"Size", "mm", true},
          {"Peak stress", "MPa", true},
          {dots("members", x, y, Ink::text), law},
          {}};
}

Chart influence_chart(const std::vector<double>& x, const std::vector<double>& y, const output::Axis& x_axis,
                      const output::Axis& y_axis) {
  return {y_axis.label + " against " + x_axis.label, x_axis, y_axis, {dots("", x, y, Ink::first)}, {}};
}

output::Drawing crack_drawing(const CrackCount& cracks, const specimen::LabelledMask& mask) {
  const auto rows = static_cast<int>(cracks.failures.rows()), cols = static_cast<int>(cracks.failures.cols());
  std::vector<double> shares;
  for (const int count : cracks.failures.reshaped<Eigen::RowMajor>())
    shares.push_back(100.0 * count / cracks.members);
  const output::ColourScale scale = output::scale_of(shares);
  specimen::Raster<specimen::Rgb> picture(rows, cols);
  for (std::size_t i = 0; i < shares.size(); ++i) picture.data[i] = scale(shares[i]);
  output::Drawing drawing{output::picture_width, 0, "How often each pixel failed", {}};
  const std::string words = fmt::format("{} members", cracks.members);
  double y = output::add_picture(drawing, output::magnified(picture, output::crisp_factor(rows, cols))) +
             output::text_line;
  y = output::add_scale_bar(drawing, output::picture_width / mask.width(), y, words);
  const bool above = *std::max_element(shares.begin(), shares.end()) > scale.high;
  y = output::add_colour_bar(drawing, {scale, "Members in which the pixel failed [%]", false, above},
                             y + 1.5 * output::text_line);
  drawing.height = y + 6;
  return drawing;
}

}  // namespace app
