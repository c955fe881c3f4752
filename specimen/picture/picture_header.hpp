/// The header of a picture, read before its pixels: format, size, scale, orientation.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

enum class PictureFormat { unknown, png, jpeg, tiff, bmp, pnm };

/// Format by the first bytes of a file (8 bytes are enough).
[[nodiscard]] PictureFormat format_of(std::span<const std::uint8_t> first_bytes);

/// Check the size that a header claims.
/// @param least_bytes  smallest possible size of the file; a shorter file is truncated, and is refused before
/// memory is allocated.
/// @throws Error for an empty or too large picture, or one whose pixels cannot be in the file.
void check_size(const PictureSource& source, std::int64_t rows, std::int64_t cols, std::int64_t least_bytes);

/// Pixel size [m] from resolutions [pixels per metre] along x and y; 0 if a pixel would not be square
/// (within 1 %) or a resolution is not a positive number.
[[nodiscard]] double pixel_size_of(double per_metre_x, double per_metre_y);

inline constexpr double inch = 0.0254;      ///< [m]
inline constexpr double centimetre = 0.01;  ///< [m]
inline constexpr Rgb paper{255, 255, 255};  ///< background of transparent pixels

/// A colour with an opacity (0 to 255), blended with the background.
[[nodiscard]] inline Rgb on_paper(Rgb colour, std::uint8_t opacity) {
  const auto mix = [&](int c, int under) {
    return static_cast<std::uint8_t>((c * opacity + under * (255 - opacity) + 127) / 255);
  };
  return {mix(colour.r, paper.r), mix(colour.g, paper.g), mix(colour.b, paper.b)};
}

/// Turn a picture upright.
/// @param orientation  1 to 8 as TIFF and EXIF count them: which side of the scene row 0 and column 0 are;
/// 1 = top and left, nothing to do.
[[nodiscard]] Picture upright(Picture picture, int orientation);

}  // namespace specimen
