/// Measures of the aggregates of a mask: contour, area, perimeter and ellipse of each grain; and the format
/// of numbers in the notes of a conversion.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {

/// Measure every grain of an instance raster.
/// The contour runs around every connected piece and every hole (loops_of), through the midpoints of the
/// pixel edges between inside and outside. The ellipse has the area of the grain, and the axis ratio and
/// direction of its second moments. The perimeter is the length of all these lines times pi / (8 (sqrt 2 -
/// 1)), which corrects the mean excess of the staircase over all directions. Source: Vossepoel, Smeulders
/// (1982).
/// @param instances  0 = none, else ids 1 ... n, each of which occurs.   @param pixel_size  [m].
[[nodiscard]] std::vector<Inclusion> measure_inclusions(const Raster<std::int32_t>& instances,
                                                        double pixel_size);

/// "1,234,567".
[[nodiscard]] std::string grouped(std::int64_t count);
/// "1 island", "1,234 islands".
[[nodiscard]] std::string counted(std::int64_t count, const std::string& noun);
/// A share in per cent: "3.2 %", or "0.004 %" if one decimal is not enough.
[[nodiscard]] std::string share_text(double part, double whole);
/// A length [m] in mm with four significant digits: "0.5 mm".
[[nodiscard]] std::string length_text(double metres);
/// An area [m^2] in mm2 with three significant digits: "2.5 mm2".
[[nodiscard]] std::string area_text(double square_metres);
/// Four significant digits, with a decimal point in every locale.
[[nodiscard]] std::string short_number(double value);

}  // namespace specimen
