/// The specimen as it is at the end of a run, whose points have left their pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "apps/drawing/damage_picture.hpp"
#include "specimen/body/mask.hpp"

namespace output {

/// Where a point is [m], y upwards from the lower left corner of the mask; nowhere when it is not finite.
struct PointPlace {
  double x = 0, y = 0;
};

/// For each pixel of a picture the number of the point next to it, and -1 where none is within three quarters
/// of a pixel of the mask along both axes: neighbours must part by half a pixel more before a gap shows
/// between them. The picture holds the mask as it was and the points as they are, up to half its width and
/// height beyond it; a point further away is not shown. With fineness 1, points that have not moved are in
/// their pixels.
/// @param fineness  pixels of the picture along an edge of a pixel of the mask, >= 1.
/// @pre fewer than 2^31 points.
[[nodiscard]] specimen::Raster<std::int32_t> nearest_points(const specimen::LabelledMask& mask,
                                                            const std::vector<PointPlace>& points,
                                                            int fineness);

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
