// Where everything of a chart goes: axes, lines, legend.
#include "apps/drawing/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/drawing/ticks.hpp"
#include "apps/text/figures.hpp"

namespace output {
namespace {

constexpr double sample_length = 18;  ///< of the line beside a name in the legend
constexpr double edge = 2;            ///< kept free all round

double text_size(const Drawing& drawing) { return 13 * drawing.text; }
double line_height(const Drawing& drawing) { return 20 * drawing.text; }

/// As wide as DejaVu Sans, the widest of the usual sans-serif faces, so that nothing is cut in another one.
double text_width(const Drawing& drawing, const std::string& text) {
  double width = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // of a UTF-8 sequence
    width += continues ? 0 : c >= '0' && c <= '9' ? 0.64 : 0.58;
  }
  return width * text_size(drawing);
}

struct Range {
  double low = 0;
  double high = 0;
  [[nodiscard]] double width() const { return high - low; }
};

using Values = std::vector<double> Series::*;

/// Of values along an axis, in its scale: of finite ones, and of zero where the axis has one.
Range range_of(const Axis& axis, const std::vector<Series>& series, Values values) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range = axis.logarithmic || axis.tight ? Range{infinity, -infinity} : Range{};
  for (const Series& line : series)
    for (const double value : line.*values)
      if (std::isfinite(value)) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
      }
  if (range.low > range.high) range = {};
  if (range.width() <= 0) range.high = range.low + 1;
  return range;
}

/// With room for a marker's words above the highest point, and round the points of an axis without zero.
Range with_headroom(const Axis& axis, Range range, bool has_words) {
  const double width = range.width();
  range.high += (has_words ? 0.14 : 0.04) * width;
  if (axis.logarithmic || axis.tight || range.low < 0) range.low -= 0.04 * width;
  return range;
}

/// On a logarithmic axis, in decades; not a number for what is not positive.
double in_scale(const Axis& axis, double value) {
  if (!axis.logarithmic) return value;
  return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

Chart in_scale(Chart chart) {
  for (Series& line : chart.series) {
    for (double& value : line.x) value = in_scale(chart.x, value);
    for (double& value : line.y) value = in_scale(chart.y, value);
  }
  for (Marker& marker : chart.markers) {
    marker.x = in_scale(chart.x, marker.x);
    marker.y = in_scale(chart.y, marker.y);
  }
  return chart;
}

/// Where a line stands, in the scale of its axis, and what is written beside it.
struct Tick {
  double at = 0;
  std::string text;
  bool is_zero = false;
};

std::vector<Tick> ticks_of(const Axis& axis, const Range& range, int at_most) {
  std::vector<Tick> ticks;
  if (axis.logarithmic) {
    for (const double value : logarithmic_ticks(std::pow(10, range.low), std::pow(10, range.high), at_most))
      ticks.push_back({std::log10(value), concise_power(value, 4)});
    return ticks;
  }
  const Ticks round = ticks_between(range.low, range.high, at_most);
  for (const double value : round.values) ticks.push_back({value, tick_text(value, round.step), value == 0});
  return ticks;
}

/// The rectangle of the data, and how data come into it.
struct Frame {
  double left = 0, right = 0, top = 0, bottom = 0;
  Range x, y;

  [[nodiscard]] Place place(double x_value, double y_value) const {
    return {left + (x_value - x.low) / x.width() * (right - left),
            bottom - (y_value - y.low) / y.width() * (bottom - top)};
  }
};

struct LegendPlace {
  const Series* series = nullptr;
  Place at;  ///< left end, on the base line
};

/// Names in rows that fill the width; none for a single line.
std::vector<LegendPlace> legend_of(const Drawing& drawing, const std::vector<Series>& series) {
  std::vector<LegendPlace> entries;
  if (series.size() < 2) return entries;
  Place at{edge, 2 * line_height(drawing)};
  for (const Series& line : series) {
    if (line.name.empty()) continue;
    const double entry_width = sample_length + 6 + text_width(drawing, line.name);
    if (at.x > edge && at.x + entry_width > drawing.width) at = {edge, at.y + line_height(drawing)};
    entries.push_back({&line, at});
    at.x += entry_width + 14;
  }
  return entries;
}

std::string title_of(const Axis& axis) {
  return axis.unit.empty() ? axis.label : axis.label + " (" + axis.unit + ")";
}

void draw_legend(Drawing& drawing, const std::vector<LegendPlace>& entries) {
  for (const LegendPlace& entry : entries) {
    const double middle = entry.at.y - 0.35 * text_size(drawing);
    drawing.shapes.emplace_back(Stroke{{{entry.at.x, middle}, {entry.at.x + sample_length, middle}},
                                       entry.series->ink,
                                       2,
                                       entry.series->dashed});
    drawing.shapes.emplace_back(Words{{entry.at.x + sample_length + 6, entry.at.y},
                                      entry.series->name,
                                      text_size(drawing),
                                      Anchor::start,
                                      Ink::text});
  }
}

void draw_y_axis(Drawing& drawing, const Frame& frame, const std::vector<Tick>& ticks) {
  for (const Tick& tick : ticks) {
    const double y = frame.place(frame.x.low, tick.at).y;
    drawing.shapes.emplace_back(
        Stroke{{{frame.left, y}, {frame.right, y}}, tick.is_zero ? Ink::axis : Ink::grid, 1});
    drawing.shapes.emplace_back(Words{{frame.left - 8, y + 0.35 * text_size(drawing)},
                                      tick.text,
                                      text_size(drawing),
                                      Anchor::end,
                                      Ink::muted});
  }
}

void draw_x_axis(Drawing& drawing, const Frame& frame, const std::vector<Tick>& ticks,
                 const std::string& title) {
  drawing.shapes.emplace_back(
      Stroke{{{frame.left, frame.bottom}, {frame.right, frame.bottom}}, Ink::axis, 1});
  for (const Tick& tick : ticks) {
    const double x = frame.place(tick.at, frame.y.low).x;
    drawing.shapes.emplace_back(Stroke{{{x, frame.bottom}, {x, frame.bottom + 5}}, Ink::axis, 1});
    drawing.shapes.emplace_back(Words{{x, frame.bottom + 5 + 1.1 * text_size(drawing)},
                                      tick.text,
                                      text_size(drawing),
                                      Anchor::middle,
                                      Ink::muted});
  }
  drawing.shapes.emplace_back(Words{
      {(frame.left + frame.right) / 2, frame.bottom + 5 + 1.1 * text_size(drawing) + line_height(drawing)},
      title,
      text_size(drawing),
      Anchor::middle,
      Ink::text});
}

void draw_series(Drawing& drawing, const Frame& frame, const Series& series) {
  for (std::vector<Place>& places : unbroken_lines(series.x, series.y)) {
    for (Place& place : places) place = frame.place(place.x, place.y);
    drawing.shapes.emplace_back(Stroke{thin_line(places), series.ink, 2, series.dashed});
  }
  if (!series.dotted) return;
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
      drawing.shapes.emplace_back(Dot{frame.place(series.x[i], series.y[i]), 3, series.ink});
}

/// Words go to the right of the point, or to the left where they would leave the drawing.
void draw_marker(Drawing& drawing, const Frame& frame, const Marker& marker) {
  if (!std::isfinite(marker.x) || !std::isfinite(marker.y)) return;
  const Place at = frame.place(marker.x, marker.y);
  const bool fits = at.x + 10 + text_width(drawing, marker.text) <= drawing.width;
  drawing.shapes.emplace_back(Dot{at, 4, Ink::text});
  if (marker.text.empty()) return;
  drawing.shapes.emplace_back(Words{{at.x + (fits ? 10 : -10), at.y - 8},
                                    marker.text,
                                    text_size(drawing),
                                    fits ? Anchor::start : Anchor::end,
                                    Ink::text});
}

double widest(const Drawing& drawing, const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, text_width(drawing, tick.text));
  return width;
}

}  // namespace

Drawing lay_out(const Chart& in_units, double width, double height, double text) {
  const Chart chart = in_scale(in_units);
  Drawing drawing{width, height, chart.title, {}, text};
  const std::vector<LegendPlace> legend =
      chart.has_legend ? legend_of(drawing, chart.series) : std::vector<LegendPlace>();

  Frame frame;
  const bool has_words = std::any_of(chart.markers.begin(), chart.markers.end(),
                                     [](const Marker& marker) { return !marker.text.empty(); });
  frame.x = range_of(chart.x, chart.series, &Series::x);
  if (chart.x.logarithmic || chart.x.tight) frame.x = with_headroom(chart.x, frame.x, false);
  frame.y = with_headroom(chart.y, range_of(chart.y, chart.series, &Series::y), has_words);
  frame.top = (legend.empty() ? line_height(drawing) : legend.back().at.y) + 0.6 * line_height(drawing);
  frame.bottom = height - 5 - 1.1 * text_size(drawing) - 1.35 * line_height(drawing);
  const std::vector<Tick> y_ticks = ticks_of(
      chart.y, frame.y, std::clamp(static_cast<int>((frame.bottom - frame.top) / (32 * text)), 2, 8));
  frame.left = edge + widest(drawing, y_ticks) + 8;
  const std::vector<Tick> x_ticks =
      ticks_of(chart.x, frame.x, std::clamp(static_cast<int>(width / (75 * text)), 2, 12));
  frame.right = width - edge - widest(drawing, x_ticks) / 2;

  drawing.shapes.emplace_back(Words{
      {edge, line_height(drawing) - 5}, title_of(chart.y), text_size(drawing), Anchor::start, Ink::text});
  draw_legend(drawing, legend);
  draw_y_axis(drawing, frame, y_ticks);
  draw_x_axis(drawing, frame, x_ticks, title_of(chart.x));
  for (const Series& series : chart.series) draw_series(drawing, frame, series);
  for (const Marker& marker : chart.markers) draw_marker(drawing, frame, marker);
  return drawing;
}

void add_line(Series& series, const std::vector<double>& x, const std::vector<double>& y, double per_x,
              double per_y) {
  if (!series.x.empty()) {
    series.x.push_back(gap);
    series.y.push_back(gap);
  }
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    series.x.push_back(per_x * x[i]);
    series.y.push_back(per_y * y[i]);
  }
}

}  // namespace output
