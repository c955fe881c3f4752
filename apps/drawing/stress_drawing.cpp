#include "apps/drawing/stress_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "apps/drawing/deformed_picture.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"

namespace output {
namespace {

/// sqrt(3 J2).
double mises(const mpm::FramePoint& p) {
  const double xy = p.sxx - p.syy, yz = p.syy - p.szz, zx = p.szz - p.sxx;
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * p.sxy * p.sxy);
}

}  // namespace

double stress_of(const mpm::FramePoint& p, StressComponent component) {
  const double centre = (p.sxx + p.syy) / 2;
  const double radius = std::hypot((p.sxx - p.syy) / 2, p.sxy);
  switch (component) {
    case StressComponent::yy:
      return p.syy;
    case StressComponent::xx:
      return p.sxx;
    case StressComponent::xy:
      return p.sxy;
    case StressComponent::first:
      return std::max(centre + radius, p.szz);
    case StressComponent::third:
      return std::min(centre - radius, p.szz);
    case StressComponent::mises:
      return mises(p);
  }
  return 0;
}

std::string phrase_of(StressComponent component, bool loaded) {
  using enum StressComponent;
  return app::word_in({{yy, loaded ? "stress in the direction of loading" : "vertical stress"},
                       {xx, loaded ? "stress across the direction of loading" : "horizontal stress"},
                       {xy, "shear stress"},
                       {first, "largest principal stress"},
                       {third, "smallest principal stress"},
                       {mises, "von Mises stress"}},
                      component);
}

namespace {

constexpr double inset = 16;      // at both ends, for numbers and points [px]
constexpr double thickness = 14;  // of the bar
constexpr double point = 12;      // length of a pointed end
constexpr double left = inset, right = picture_width - inset;

specimen::Raster<specimen::Rgb> gradient(const ColourScale& scale) {
  constexpr int steps = 2 * static_cast<int>(right - left);
  specimen::Raster<specimen::Rgb> picture(1, steps);
  for (int i = 0; i < steps; ++i)
    picture(0, i) = scale(scale.low + (i + 0.5) / steps * (scale.high - scale.low));
  return picture;
}

/// The corners of the bar on its way round, pointed ends included.
std::vector<Place> outline(const ColourBar& bar, double top) {
  std::vector<Place> places{{left, top}, {right, top}};
  if (bar.more_above) places.push_back({right + point, top + thickness / 2});
  places.insert(places.end(), {{right, top + thickness}, {left, top + thickness}});
  if (bar.more_below) places.push_back({left - point, top + thickness / 2});
  places.push_back(places.front());
  return places;
}

Area pointed(double from, double to, double top, specimen::Rgb colour) {
  return {{{from, top}, {to, top + thickness / 2}, {from, top + thickness}}, colour};
}

/// As many as there is room for, so that the ends have one where they are round.
Ticks ticks_of(const ColourScale& scale, double text) {
  for (int most = std::max(3, static_cast<int>(11 / text)); most >= 3; --most) {
    const Ticks ticks = ticks_between(scale.low, scale.high, most);
    const double slack = 1e-6 * ticks.step;
    if (!ticks.values.empty() && ticks.values.front() - scale.low < slack &&
        scale.high - ticks.values.back() < slack)
      return ticks;
  }
  return ticks_between(scale.low, scale.high, std::max(3, static_cast<int>(9 / text)));
}

void add_ticks(Drawing& drawing, const ColourScale& scale, double y) {
  const Ticks ticks = ticks_of(scale, drawing.text);
  for (const double value : ticks.values) {
    const double x = left + (value - scale.low) / (scale.high - scale.low) * (right - left);
    drawing.shapes.push_back(Stroke{{{x, y}, {x, y + 5}}, Ink::axis, 1});
    drawing.shapes.push_back(Words{
        {x, y + 6 + 13 * drawing.text}, tick_text(value, ticks.step), 13 * drawing.text, Anchor::middle});
  }
}

}  // namespace

double add_colour_bar(Drawing& drawing, const ColourBar& bar, double y) {
  const double top = add_words(drawing, bar.title, y, 14 * drawing.text) + 9;
  drawing.shapes.push_back(Pixels{{left, top}, right - left, thickness, gradient(bar.scale)});
  if (bar.more_below) drawing.shapes.push_back(pointed(left, left - point, top, bar.scale(bar.scale.low)));
  if (bar.more_above) drawing.shapes.push_back(pointed(right, right + point, top, bar.scale(bar.scale.high)));
  drawing.shapes.push_back(Stroke{outline(bar, top), Ink::axis, 0.75});
  add_ticks(drawing, bar.scale, top + thickness);
  return top + thickness + 6 + 13 * drawing.text;
}

namespace {

using specimen::LabelledMask;
using specimen::Raster;
using specimen::Rgb;

constexpr Rgb failed_ink{0, 0, 0};
constexpr Rgb paper{255, 255, 255};
constexpr double per_mpa = 1e-6;

bool has_failed(const mpm::FramePoint& point) { return point.damage >= 1; }

/// For each pixel of the picture the place of its point in the frame; -1 = none.
Raster<std::int32_t> points_of(const LabelledMask& mask, const mpm::Frame& frame, bool moved) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const std::size_t pixels = mask.labels.size();
  const int factor = crisp_factor(mask.labels.rows, mask.labels.cols);
  if (moved) {
    std::vector<PointPlace> places;
    places.reserve(frame.points.size());
    for (const mpm::FramePoint& point : frame.points)
      places.push_back(point.id < pixels ? PointPlace{point.x, point.y} : PointPlace{nowhere, nowhere});
    return nearest_points(mask, places, factor);
  }
  Raster<std::int32_t> points(mask.labels.rows * factor, mask.labels.cols * factor, -1);
  for (std::size_t i = 0; i < frame.points.size() && frame.points[i].id < pixels; ++i) {
    const int row = static_cast<int>(frame.points[i].id) / mask.labels.cols * factor;
    const int col = static_cast<int>(frame.points[i].id) % mask.labels.cols * factor;
    for (int k = 0; k < factor * factor; ++k)
      points(row + k / factor, col + k % factor) = static_cast<std::int32_t>(i);
  }
  return points;
}

/// Of the points that are shown in a colour [MPa].
std::vector<double> shown_stresses(const LabelledMask& mask, const mpm::Frame& frame,
                                   StressComponent component) {
  std::vector<double> values;
  for (const mpm::FramePoint& point : frame.points)
    if (point.id < mask.labels.size() && !has_failed(point))
      values.push_back(per_mpa * stress_of(point, component));
  return values;
}

Raster<Rgb> picture_of(const Raster<std::int32_t>& points, const mpm::Frame& frame, StressComponent component,
                       const ColourScale& scale) {
  std::vector<Rgb> colours;
  colours.reserve(frame.points.size());
  for (const mpm::FramePoint& point : frame.points)
    colours.push_back(has_failed(point) ? failed_ink : scale(per_mpa * stress_of(point, component)));
  Raster<Rgb> picture(points.rows, points.cols, paper);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (points.data[i] >= 0) picture.data[i] = colours[static_cast<std::size_t>(points.data[i])];
  return picture;
}

/// How many values lie beyond the ends.
struct Beyond {
  std::ptrdiff_t below = 0, above = 0, all = 0;
};

Beyond beyond(const std::vector<double>& values, const ColourScale& scale) {
  return {std::count_if(values.begin(), values.end(), [&](double v) { return v < scale.low; }),
          std::count_if(values.begin(), values.end(), [&](double v) { return v > scale.high; }),
          static_cast<std::ptrdiff_t>(values.size())};
}

std::string share_text(std::ptrdiff_t count, std::ptrdiff_t all) {
  const double share = static_cast<double>(count) / static_cast<double>(all);
  return share < 0.0005 ? "under " + percent(0.001) : percent(share);
}

/// "pointed ends: 0.9 % of the points lie below, 1.0 % above"; empty where all lie within.
std::string words_of(const Beyond& beyond) {
  const bool both = beyond.below > 0 && beyond.above > 0;
  if (both)
    return "pointed ends: " + share_text(beyond.below, beyond.all) + " of the points lie below, " +
           share_text(beyond.above, beyond.all) + " above";
  if (beyond.below > 0)
    return "pointed end: " + share_text(beyond.below, beyond.all) + " of the points lie below";
  if (beyond.above > 0)
    return "pointed end: " + share_text(beyond.above, beyond.all) + " of the points lie above";
  return {};
}

std::string title_of(const StressLook& look) {
  const bool has_sign = look.component != StressComponent::mises;
  return phrase_of(look.component, look.loaded) + " [MPa]" + (has_sign ? ", tension positive" : "");
}

std::vector<LegendEntry> legend_of(const Raster<std::int32_t>& points, const mpm::Frame& frame, bool moved) {
  std::vector<LegendEntry> entries;
  if (std::any_of(frame.points.begin(), frame.points.end(), has_failed))
    entries.push_back({failed_ink, "failed"});
  if (std::count(points.data.begin(), points.data.end(), -1) > 0)
    entries.push_back({paper, moved ? "no material" : "void"});
  return entries;
}

}  // namespace

Drawing stress_drawing(const LabelledMask& mask, const mpm::Frame& frame, const StressLook& look) {
  const std::vector<double> values = shown_stresses(mask, frame, look.component);
  const ColourScale scale = look.range ? *look.range : scale_of(values);
  const Beyond ends = beyond(values, scale);
  const Raster<std::int32_t> points = points_of(mask, frame, look.moved);
  Drawing drawing{picture_width, 0, title_of(look) + "; " + look.words, {}, look.text};
  const double line = text_line * look.text;
  double y = add_picture(drawing, picture_of(points, frame, look.component, scale)) + line;
  const double metres = points.cols * mask.pixel_size / crisp_factor(mask.labels.rows, mask.labels.cols);
  y = add_scale_bar(drawing, picture_width / metres, y, look.words);
  y = add_colour_bar(drawing, {scale, title_of(look), ends.below > 0, ends.above > 0}, y + 1.5 * line);
  if (const std::string words = words_of(ends); !words.empty()) {
    y = add_words(drawing, words, y + line, 13 * look.text, Ink::muted);
  }
  const std::vector<LegendEntry> legend = legend_of(points, frame, look.moved);
  if (!legend.empty()) y = add_legend(drawing, legend, y + line + 4);
  drawing.height = y + 6;
  return drawing;
}

}  // namespace output
