/// A drawing, or pixels, as the bytes of a file: PNG, SVG or PDF; and as inline SVG.
#pragma once

#include <string>

#include "apps/drawing/drawing.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// Anti-aliased, on white paper.
/// @param scale  pixels per px of the drawing.   @param margin  of paper on every side [px of the drawing].
/// @param per_inch  pixels per inch in print that the file states; 0 = it states none.
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string png_of(const Drawing& drawing, double scale, double margin = 0,
                                 double per_inch = 0);

/// One pixel a pixel.   @throws as above.
[[nodiscard]] std::string png_of(const specimen::Raster<specimen::Rgb>& picture);

enum class VectorFormat { svg, pdf };

/// On white paper.
/// @param margin  of paper on every side [px of the drawing].   @param points_per_px  in print.
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string vector_file(const Drawing& drawing, VectorFormat format, double margin,
                                      double points_per_px = 0.75);

/// SVG element that scales with its column. Colours come from the classes "stroke-NAME" and "fill-NAME" of
/// the page's style sheet (NAME = name_of(ink)), so that they follow light and dark paper.
[[nodiscard]] std::string svg_of(const Drawing& drawing);

}  // namespace output
