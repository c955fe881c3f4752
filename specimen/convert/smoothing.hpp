/// Smoothing before segmentation: averaging and median of grey levels; and local roughness.
#pragma once

#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Mean over squares of factor x factor pixels; the last squares of a row or column average the remaining
/// pixels.
[[nodiscard]] Raster<double> shrunk(const Raster<double>& picture, int factor);
[[nodiscard]] Raster<Rgb> shrunk(const Raster<Rgb>& picture, int factor);

/// Median over a square window that is cut off at the borders of the picture. Values of more than 65,536
/// different levels are resolved to 1/65,536 of their span.
/// @param edge  of the window [px], odd.
[[nodiscard]] Raster<double> median_of(const Raster<double>& picture, int edge);

/// Mean over a square window that is cut off at the borders.   @param edge  of the window [px], odd.
[[nodiscard]] Raster<double> local_mean(const Raster<double>& values, int edge);

/// Roughness of a picture around each pixel: the smallest standard deviation over the four squares of `edge`
/// pixels with the pixel in a corner, so that the edge between two smooth regions stays smooth. Source: the
/// windows are those of Kuwahara, Hachimura, Eiho, Kinoshita (1976).
[[nodiscard]] Raster<double> roughness(const Raster<double>& values, int edge);

}  // namespace specimen
