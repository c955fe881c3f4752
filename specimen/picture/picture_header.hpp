/// The header of a picture, read before its pixels: format, size, scale, orientation.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

enum class PictureFormat { unknown, png, jpeg, tiff, bmp, pnm, hdf5 };  // the last is none

/// Format by the first bytes of a file (8 bytes are enough).
[[nodiscard]] PictureFormat format_of(std::span<const std::uint8_t> first_bytes);

/// Check the size that a header claims.
/// @param least_bytes  smallest possible size of the file; a shorter file is truncated, and is refused before
/// memory is allocated.
/// Tells the size to the listener of the source.
/// @throws Error for an empty or too large picture, or one whose pixels cannot be in the file.
void check_size(const PictureSource& source, std::int64_t rows, std::int64_t cols, std::int64_t least_bytes);

/// Width and shape of a pixel.
struct PixelShape {
  double width = 0;   ///< [m]; 0 = unknown
  double aspect = 1;  ///< height over width [-]
};

/// Shape of a pixel from resolutions [pixels per metre] along x and y; square within 1 %. Unknown if one of
/// them is not a positive number, or if one is more than ten times the other.
[[nodiscard]] PixelShape pixel_shape_of(double per_metre_x, double per_metre_y);

/// Give a picture this shape of its pixels.
inline void set_shape(Picture& picture, PixelShape shape) {
  picture.pixel_size = shape.width;
  picture.pixel_aspect = shape.aspect;
}

inline constexpr double inch = 0.0254;      ///< [m]
inline constexpr double centimetre = 0.01;  ///< [m]

/// Turn a picture upright.
/// @param orientation  1 to 8 as TIFF and EXIF count them: which side of the scene row 0 and column 0 are;
/// 1 = top and left, nothing to do.
[[nodiscard]] Picture upright(Picture picture, int orientation);

}  // namespace specimen
