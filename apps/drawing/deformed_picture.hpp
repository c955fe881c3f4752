/// The specimen as it is at the end of a run with moving points.
#pragma once

#include "apps/drawing/damage_picture.hpp"

namespace output {

/// Whether the run says where its points are at the end.
[[nodiscard]] bool has_end(const mpm::Result& result);

/// Each pixel has the colour, failures included, of the point that nearest_points() gives it, and that of
/// void where it gives none. With fineness 1 and points that have not moved it is the picture of damage at
/// the end.
/// @param fineness  pixels of the picture along an edge of a pixel of the mask, >= 1.
/// @pre has_end(result), and the maps have the shape of the mask.
[[nodiscard]] specimen::Raster<specimen::Rgb> deformed_picture(const specimen::LabelledMask& mask,
                                                               const mpm::Result& result,
                                                               const Palette& palette, int fineness);

/// "deformed.png", "deformed_colour.png".
[[nodiscard]] std::string deformed_name(bool colour);

}  // namespace output
