/// What a chart says: data, axes, series. How it looks is the matter of chart_layout and the renderers.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "apps/drawing/colours.hpp"
#include "apps/drawing/drawing.hpp"

namespace output {

/// A quantity along an axis, in the unit that is shown.
struct Axis {
  std::string label;         ///< "Stress"
  std::string unit;          ///< "MPa"
  bool logarithmic = false;  ///< values that are not positive leave a gap
  bool tight = false;        ///< reaches as far as the values do, and not to zero
};

/// A line through points; points that are not finite leave a gap.
struct Series {
  std::string name;       ///< in the legend; empty = not there
  std::vector<double> x;  ///< in the unit of the axis, rising
  std::vector<double> y;  ///< same length
  Ink ink = Ink::first;
  bool dashed = false;
  bool dotted = false;  ///< a dot on each of its points
};

/// Where a line is broken.
inline constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Goes on with a line behind a gap, as far as both x and y reach.
/// @param per_x, per_y  units of the axes in those of x and y.
void add_line(Series& series, const std::vector<double>& x, const std::vector<double>& y, double per_x = 1,
              double per_y = 1);

/// A point that is pointed out, with a few words or none.
struct Marker {
  double x = 0;
  double y = 0;
  std::string text;
};

struct Chart {
  std::string title;  ///< for those who cannot see it
  Axis x;
  Axis y;
  std::vector<Series> series;  ///< more than one: a legend is drawn
  std::vector<Marker> markers;
  bool has_legend = true;
};

/// Lay a chart out in a width and height [px]. A line with more points than can be seen is thinned to the
/// first, last, lowest and highest of each half column of pixels, which leaves its picture as it was.
/// @param text  size of the words over the usual one, 13 px.
[[nodiscard]] Drawing lay_out(const Chart& chart, double width, double height, double text = 1);

}  // namespace output
