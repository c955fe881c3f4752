/// Grey levels and colours of a picture, the same whatever it is stored as.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Whether a picture has colours: not where red, green and blue are alike everywhere.
[[nodiscard]] bool is_coloured(const Picture& picture);

/// Grey value of pixel i of a picture without colours.
[[nodiscard]] inline double gray_at(const Picture& picture, std::size_t i) {
  return picture.gray.empty() ? picture.colour.data[i].r : picture.gray.data[i];
}

/// Bring the few values far outside of the range of all others (a hot pixel of a detector) to the ends of
/// this range. Bytes stay as they are.
/// @return a note that names them and the first of them; empty where there are none.
std::string tame_outliers(GreyLevels& gray);

/// A picture in the form that all its encodings share: grey where it has no colours, in the smallest numbers
/// that hold it; what a palette shows, with its indices as names, or still there where some show the same.
[[nodiscard]] Picture in_common_form(Picture picture);

/// Grey as colour, each level the byte that it is in an encoding of 8 bits:
/// - bytes as they are; fewer bits, and bytes that were multiplied (by 257, 256, 16, ...), brought to bytes;
/// - values that use a fifth or more of 10, 12, 14 or 16 bits, or of the range from 0 to 1, as shares of
/// it;
/// - others with their span brought to 0 ... 255.
/// Not-a-number becomes black.
/// @param bits  per value, as stored.
[[nodiscard]] Raster<Rgb> as_colour(const GreyLevels& gray, int bits = 8);

/// Whether as_colour() spreads the values, so that the darkest of them need not be black.
[[nodiscard]] bool is_spread(const GreyLevels& gray, int bits = 8);

/// The colours of a picture, grey by as_colour() after tame_outliers().
[[nodiscard]] Raster<Rgb> shown_colours(const Picture& picture);

}  // namespace specimen
