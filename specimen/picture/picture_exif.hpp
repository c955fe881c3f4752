/// The two facts of a camera's EXIF block that matter here: which side is up, and the resolution.
#pragma once

#include <cstdint>
#include <span>

namespace specimen {

struct ExifTags {
  int orientation = 1;    ///< 1 to 8, see upright()
  double pixel_size = 0;  ///< [m]; 0 = not said
};

/// Read the first directory of an EXIF block ("Exif\0\0", then a small TIFF). Whatever is missing or damaged
/// in it keeps its default: the picture itself does not depend on it.
[[nodiscard]] ExifTags read_exif(std::span<const std::uint8_t> block);

}  // namespace specimen
