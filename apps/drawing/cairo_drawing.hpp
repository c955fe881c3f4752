/// Drawings by the cairo library. Private to the files that end in its formats.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "apps/drawing/drawing.hpp"

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
