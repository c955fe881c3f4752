/// Where everything of a chart goes.
#pragma once

#include "apps/drawing/chart.hpp"
#include "apps/drawing/drawing.hpp"

namespace output {

/// Lay a chart out in a width and height [px]. A line with more points than can be seen is thinned to the
/// first, last, lowest and highest of each half column of pixels, which leaves its picture as it was.
[[nodiscard]] Drawing lay_out(const Chart& chart, double width, double height);

}  // namespace output
