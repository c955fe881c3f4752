/// Making a picture calmer before its pixels are sorted: averaging and the median of grey levels.
#pragma once

#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Mean over squares of factor x factor pixels; the last ones of a row or column average what there is.
[[nodiscard]] Raster<double> shrunk(const Raster<double>& picture, int factor);
[[nodiscard]] Raster<Rgb> shrunk(const Raster<Rgb>& picture, int factor);

/// Median over a square window that is cut off at the borders of the picture. Values of more than 65,536
/// different levels are told apart to 1/65,536 of their span.
/// @param edge  of the window [px], odd.
[[nodiscard]] Raster<double> median_of(const Raster<double>& picture, int edge);

/// Mean over a square window that is cut off at the borders.   @param edge  of the window [px], odd.
[[nodiscard]] Raster<double> local_mean(const Raster<double>& values, int edge);

/// How rough a picture is round each pixel: the least standard deviation of the values over the four squares
/// of `edge` pixels that have the pixel in a corner, so that the rim between two smooth parts stays smooth.
/// Source: the windows are those of Kuwahara, Hachimura, Eiho, Kinoshita (1976).
[[nodiscard]] Raster<double> roughness(const Raster<double>& values, int edge);

}  // namespace specimen
