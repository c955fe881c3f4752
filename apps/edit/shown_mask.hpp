/// What a page shows of a mask: where it lies on the picture, and two bytes a pixel.
#pragma once

#include <cstdint>
#include <string>

#include "specimen/body/specimen.hpp"
#include "specimen/convert/convert.hpp"

namespace app {

/// The pixels of a mask for a page, and the part of the picture that they cover.
struct ShownMask {
  int rows = 0, cols = 0;
  double x = 0, y = 0;            ///< of the top left corner on the picture [px]
  double step_x = 1, step_y = 1;  ///< of a pixel on the picture [px]
  std::string bytes{};            ///< labels, row by row, then as many flags
};

inline constexpr std::uint8_t boundary_flag = 1;   ///< another phase or grain begins to the right or below
inline constexpr std::uint8_t uncertain_flag = 2;  ///< two phases are nearly as likely

/// @param uncertain  as of specimen::Converted, whole pixels for each of the mask; or empty.
/// @param crop  of the picture.   @param cols  of the picture [px].   @param aspect  of its pixels, height
/// over width.
[[nodiscard]] ShownMask shown_mask(const specimen::Segmented& segmented,
                                   const specimen::Raster<std::uint8_t>& uncertain,
                                   const specimen::Crop& crop, int cols, double aspect);

/// Red, green and blue of a picture, at most so many pixels of it.
struct ShownPicture {
  int rows = 0, cols = 0;  ///< of what is shown
  std::string bytes{};     ///< shape (rows, cols, 3)
};
[[nodiscard]] ShownPicture shown_picture(const specimen::Picture& picture, double most_pixels);

}  // namespace app
