/// Aggregates of a mask: contour, area, perimeter and ellipse of each grain.
/// How figures read in the notes of a conversion.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
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

/// "1,234,567".
[[nodiscard]] std::string grouped(std::int64_t count);
/// "1 island", "1,234 islands".
[[nodiscard]] std::string counted(std::int64_t count, const std::string& noun);
/// "3.2 %" of a share; "0.004 %" where one decimal would say nothing.
[[nodiscard]] std::string share_text(double part, double whole);
/// "0.5 mm" of metres, four significant digits.
[[nodiscard]] std::string length_text(double metres);
/// "2.5 mm2" of square metres, three significant digits.
[[nodiscard]] std::string area_text(double square_metres);
/// Four significant digits, a point whatever the locale.
[[nodiscard]] std::string short_number(double value);

}  // namespace specimen
