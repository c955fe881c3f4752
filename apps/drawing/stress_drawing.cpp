#include "apps/drawing/stress_drawing.hpp"

#include <algorithm>
#include <limits>

#include "apps/drawing/colour_bar.hpp"
#include "apps/drawing/nearest_points.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/picture_scale.hpp"
#include "apps/text/text.hpp"

namespace output {
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
  Drawing drawing{picture_width, 0, title_of(look) + "; " + look.words, {}};
  double y = add_picture(drawing, picture_of(points, frame, look.component, scale)) + text_line;
  const double metres = points.cols * mask.pixel_size / crisp_factor(mask.labels.rows, mask.labels.cols);
  add_scale_bar(drawing, picture_width / metres, y, look.words);
  y = add_colour_bar(drawing, {scale, title_of(look), ends.below > 0, ends.above > 0}, y + 1.5 * text_line);
  if (const std::string words = words_of(ends); !words.empty()) {
    y += text_line;
    drawing.shapes.push_back(Words{{0, y}, words, 13, Anchor::start, Ink::muted});
  }
  const std::vector<LegendEntry> legend = legend_of(points, frame, look.moved);
  if (!legend.empty()) y = add_legend(drawing, legend, y + text_line + 4);
  drawing.height = y + 6;
  return drawing;
}

}  // namespace output
