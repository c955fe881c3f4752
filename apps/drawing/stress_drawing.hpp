/// The stress field as a picture, with its scale and legend.
#pragma once

#include <optional>
#include <string>

#include "apps/drawing/colours.hpp"
#include "apps/drawing/drawing.hpp"
#include "libmpm/solver/frame.hpp"
#include "specimen/body/mask.hpp"

namespace output {

/// first and third are the largest and the smallest of the three principal stresses, that out of the plane
/// included.
enum class StressComponent { yy, xx, xy, first, third, mises };

/// Of what the point carries [Pa]; tension is positive.
[[nodiscard]] double stress_of(const mpm::FramePoint& point, StressComponent component);

/// "stress in the direction of loading".
/// @param loaded  between platens, which move along y.
[[nodiscard]] std::string phrase_of(StressComponent component, bool loaded);

struct ColourBar {
  ColourScale scale;
  std::string title;        ///< with the unit
  bool more_below = false;  ///< values lie below the scale: its end is pointed
  bool more_above = false;
};

/// A title, and below it the bar with ticks.
/// @param y  of the title's base line.   @return y of the base line of the ticks' numbers.
double add_colour_bar(Drawing& drawing, const ColourBar& bar, double y);

struct StressLook {
  StressComponent component = StressComponent::yy;
  bool loaded = true;                     ///< between platens
  bool moved = false;                     ///< points are drawn where they are, else in their pixels
  std::optional<ColourScale> range = {};  ///< [MPa]; none = that of scale_of()
  std::string words = {};                 ///< below the picture
  double text = 1;                        ///< size of all words over the usual one
};

/// The points of the pixels in the colours of their stress, failed ones (damage 1) in black, and white where
/// there is none, with a scale bar, a colour bar in MPa and a legend. Extra points, which share a pixel with
/// another one, are not shown. Ends of the colour bar beyond which there are values are pointed, and how
/// many these are is said below.
/// @pre the ids of the frame are those of the mask; stresses are finite.
[[nodiscard]] Drawing stress_drawing(const specimen::LabelledMask& mask, const mpm::Frame& frame,
                                     const StressLook& look);

}  // namespace output
