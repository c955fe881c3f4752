/// A drawing, or pixels, as PNG bytes.
#pragma once

#include <string>

#include "apps/drawing/drawing.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// Anti-aliased, on white paper.
/// @param scale  pixels per px of the drawing.   @param margin  of paper on every side [px of the drawing].
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string png_of(const Drawing& drawing, double scale, double margin = 0);

/// One pixel a pixel.   @throws as above.
[[nodiscard]] std::string png_of(const specimen::Raster<specimen::Rgb>& picture);

}  // namespace output
