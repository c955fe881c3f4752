/// What the tags of a TIFF say beside its pixels: its description, its scale, what this program wrote into
/// it.
#pragma once

#include <tiffio.h>

#include <cstdint>
#include <string_view>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {

/// A tag of 16 bits, or its default; `otherwise` where there is neither.
[[nodiscard]] int short_tag(TIFF* tiff, std::uint32_t tag, int otherwise);

/// The description, as long as the file is open; empty = there is none.
[[nodiscard]] std::string_view description_of(TIFF* tiff);

/// The value of a line "key=value" in a description by ImageJ; empty = there is none.
[[nodiscard]] std::string_view imagej_value(std::string_view description, std::string_view key);

/// Shape of a pixel: by OME-XML in the description, by the unit that ImageJ writes there, or by the tags
/// alone.
[[nodiscard]] PixelShape tiff_pixel_shape(TIFF* tiff);

/// Origin and phases of a picture that this program wrote.
void read_tiff_words(TIFF* tiff, Picture& picture);

}  // namespace specimen
