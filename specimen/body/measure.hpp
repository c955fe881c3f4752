/// Aggregates of a mask: contour, area, perimeter and ellipse of each grain.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/inclusion.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {

/// Measure every grain of an instance raster.
/// The contour runs round the largest connected piece, through the middles of the pixel edges between inside
/// and outside; the ellipse has the axes' ratio and direction of the second moments and the area of the
/// grain; the perimeter is the length of the contour times pi / (8 (sqrt 2 - 1)), which takes the mean over
/// all directions of the staircase's excess off. Source: Vossepoel, Smeulders (1982).
/// @param instances  0 = none, else ids 1 ... n, each of which occurs.   @param pixel_size  [m].
[[nodiscard]] std::vector<Inclusion> measure_inclusions(const Raster<std::int32_t>& instances,
                                                        double pixel_size);

}  // namespace specimen
