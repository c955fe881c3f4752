/// Pictures of points that have left their pixels.
#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace output
