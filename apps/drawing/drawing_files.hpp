/// Drawings by the cairo library. Private to the files that end in its formats.
/// A drawing, or pixels, as PNG bytes.
/// A drawing as a file that can be enlarged without end.
/// A drawing as inline SVG.
#pragma once

#include <cairo.h>
#include <memory>
#include <string>

#include "apps/drawing/drawing.hpp"
#include "specimen/picture/picture.hpp"

namespace output::cairo {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

/// @throws std::runtime_error for what the library says went wrong.
void require(cairo_status_t status);

/// What the library writes, as bytes.
cairo_status_t append(void* text, const unsigned char* data, unsigned int size);

/// A picture, one pixel a pixel.
[[nodiscard]] Surface surface_of(const specimen::Raster<specimen::Rgb>& picture);

/// Draws on white paper with a margin on every side [px of the drawing].
/// @param scale  units of the surface per px of the drawing.
void draw(cairo_surface_t* surface, const Drawing& drawing, double scale, double margin);

}  // namespace output::cairo

namespace output {

/// Anti-aliased, on white paper.
/// @param scale  pixels per px of the drawing.   @param margin  of paper on every side [px of the drawing].
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string png_of(const Drawing& drawing, double scale, double margin = 0);

/// One pixel a pixel.   @throws as above.
[[nodiscard]] std::string png_of(const specimen::Raster<specimen::Rgb>& picture);

enum class VectorFormat { svg, pdf };

/// On white paper. A px of the drawing is 3/4 of a point.
/// @param margin  of paper on every side [px of the drawing].
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string vector_file(const Drawing& drawing, VectorFormat format, double margin);

/// SVG element that scales with its column. Colours come from the classes "stroke-NAME" and "fill-NAME" of
/// the page's style sheet (NAME = name_of(ink)), so that they follow light and dark paper.
[[nodiscard]] std::string svg_of(const Drawing& drawing);

}  // namespace output
