#include "apps/drawing/colour_bar.hpp"

#include <utility>
#include <vector>

#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/ticks.hpp"

namespace output {
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
Ticks ticks_of(const ColourScale& scale) {
  for (int most = 11; most >= 3; --most) {
    const Ticks ticks = ticks_between(scale.low, scale.high, most);
    const double slack = 1e-6 * ticks.step;
    if (!ticks.values.empty() && ticks.values.front() - scale.low < slack &&
        scale.high - ticks.values.back() < slack)
      return ticks;
  }
  return ticks_between(scale.low, scale.high, 9);
}

void add_ticks(Drawing& drawing, const ColourScale& scale, double y) {
  const Ticks ticks = ticks_of(scale);
  for (const double value : ticks.values) {
    const double x = left + (value - scale.low) / (scale.high - scale.low) * (right - left);
    drawing.shapes.push_back(Stroke{{{x, y}, {x, y + 5}}, Ink::axis, 1});
    drawing.shapes.push_back(Words{{x, y + 19}, tick_text(value, ticks.step), 13, Anchor::middle});
  }
}

}  // namespace

double add_colour_bar(Drawing& drawing, const ColourBar& bar, double y) {
  const double top = y + 9;
  drawing.shapes.push_back(Words{{0, y}, bar.title, 14});
  drawing.shapes.push_back(Pixels{{left, top}, right - left, thickness, gradient(bar.scale)});
  if (bar.more_below) drawing.shapes.push_back(pointed(left, left - point, top, bar.scale(bar.scale.low)));
  if (bar.more_above) drawing.shapes.push_back(pointed(right, right + point, top, bar.scale(bar.scale.high)));
  drawing.shapes.push_back(Stroke{outline(bar, top), Ink::axis, 0.75});
  add_ticks(drawing, bar.scale, top + thickness);
  return top + thickness + 19;
}

}  // namespace output
