/// What the colours of a picture mean.
#pragma once

#include <string>

#include "apps/drawing/colour_scale.hpp"
#include "apps/drawing/drawing.hpp"

namespace output {

struct ColourBar {
  ColourScale scale;
  std::string title;        ///< with the unit
  bool more_below = false;  ///< values lie below the scale: its end is pointed
  bool more_above = false;
};

/// A title, and below it the bar with ticks.
/// @param y  of the title's base line.   @return y of the base line of the ticks' numbers.
double add_colour_bar(Drawing& drawing, const ColourBar& bar, double y);

}  // namespace output
