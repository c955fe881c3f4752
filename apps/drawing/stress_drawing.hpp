/// A picture of stress with all that a reader needs beside it.
#pragma once

#include <optional>

#include "apps/drawing/colour_scale.hpp"
#include "apps/drawing/drawing.hpp"
#include "apps/drawing/stress_component.hpp"
#include "specimen/body/mask.hpp"

namespace output {

struct StressLook {
  StressComponent component = StressComponent::yy;
  bool loaded = true;                     ///< between platens
  bool moved = false;                     ///< points are drawn where they are, else in their pixels
  std::optional<ColourScale> range = {};  ///< [MPa]; none = that of scale_of()
  std::string words = {};                 ///< below the picture
};

/// The points of the pixels in the colours of their stress, failed ones (damage 1) in black, and white where
/// there is none, with a scale bar, a colour bar in MPa and a legend. Extra points, which share a pixel with
/// another one, are not shown. Ends of the colour bar beyond which there are values are pointed, and how
/// many these are is said below.
/// @pre the ids of the frame are those of the mask; stresses are finite.
[[nodiscard]] Drawing stress_drawing(const specimen::LabelledMask& mask, const mpm::Frame& frame,
                                     const StressLook& look);

}  // namespace output
