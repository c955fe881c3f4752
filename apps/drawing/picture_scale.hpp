/// Pictures in another size, by whole factors only.
#pragma once

#include "specimen/picture/picture.hpp"

namespace output {

/// Every pixel becomes factor x factor pixels.   @pre factor >= 1.
[[nodiscard]] specimen::Raster<specimen::Rgb> magnified(const specimen::Raster<specimen::Rgb>& picture,
                                                        int factor);

/// Every factor x factor pixels (fewer at the right and bottom edge) become their mean.   @pre factor >= 1.
[[nodiscard]] specimen::Raster<specimen::Rgb> shrunk(const specimen::Raster<specimen::Rgb>& picture,
                                                     int factor);

/// Smallest whole factor that brings a picture to at least 600 pixels in width without bringing its height
/// above 4000; 1 where it has them.
[[nodiscard]] int file_magnification(int rows, int cols);

/// Smallest whole factor that brings both sides to at most `most` pixels.
[[nodiscard]] int shrink_factor(int rows, int cols, int most);

}  // namespace output
