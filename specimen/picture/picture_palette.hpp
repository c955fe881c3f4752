/// Pictures whose pixels are indices into a table of colours.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

/// Fill a picture from indices and their palette: the indices are kept, and beside them stand the colours, or
/// grey values where the palette holds nothing but greys.
/// @throws Error naming the first pixel whose index is not in the palette.
void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette);

}  // namespace specimen
