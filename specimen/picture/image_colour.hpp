/// Colour pictures: Lab, single channels, smoothing; and Euclidean distances in a picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// A colour of CIE 1976 L*a*b* (D65) in 8-bit codes, computed in integers so that all machines agree.
struct Lab {
  std::uint8_t l_code = 0, a_code = 128, b_code = 128;
  [[nodiscard]] double l() const { return l_code * (100.0 / 255); }  ///< lightness, 0 to 100
  [[nodiscard]] double a() const { return a_code - 128.0; }          ///< green (-) to red (+)
  [[nodiscard]] double b() const { return b_code - 128.0; }          ///< blue (-) to yellow (+)
};

[[nodiscard]] Raster<Lab> to_lab(const Raster<Rgb>& picture);

/// As in a style sheet: "#708096".
[[nodiscard]] std::string colour_text(Rgb colour);

/// Names of the channels of a colour picture.
[[nodiscard]] const std::vector<std::string>& channel_names();

/// One channel of a colour picture. gray (0.299 R + 0.587 G + 0.114 B), red, green, blue, value, saturation:
/// 0 to 255; hue: 0 to 360 degrees; l: 0 to 100; a, b: -128 to 127.
[[nodiscard]] Raster<double> channel_of(const Raster<Rgb>& picture, const std::string& name);

/// Median over a square window, per channel.   @param edge  of the window [px], odd.
[[nodiscard]] Raster<Rgb> median_of(const Raster<Rgb>& picture, int edge);

/// Distance of every pixel with a non-zero value to the nearest pixel with zero, from centre to centre [px];
/// 0 at the zeros themselves. There is nothing beyond the borders of the picture. Without any zero: larger
/// than the picture.
[[nodiscard]] Raster<float> distance_to_zero(const Raster<std::uint8_t>& mask);

}  // namespace specimen
