/// Pictures for the eye: the mask in colours.
#pragma once

#include "specimen/body/mask.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Colour of each phase: void white, aggregate blue-grey, mortar sand, ITZ dark orange, others from a
/// colour-blind-safe list.
[[nodiscard]] Rgb phase_colour(std::uint8_t label);

/// The mask in these colours, one pixel a pixel.
[[nodiscard]] Raster<Rgb> preview(const LabelledMask& mask);

}  // namespace specimen
