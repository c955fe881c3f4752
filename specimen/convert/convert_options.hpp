/// Checks of the options of a conversion; the crop and the scale that they define.
#pragma once

#include <cstdint>
#include <string>

#include "specimen/convert/convert.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Check each option by itself and against the method.   @throws Error naming the option.
void check_options(const ConvertOptions& options);

/// The cropped picture.   @throws Error if the crop exceeds the picture.
[[nodiscard]] Picture cropped(Picture picture, const Crop& crop);

/// The same of one value a pixel, which lies over a picture.
[[nodiscard]] Raster<std::uint8_t> cropped(Raster<std::uint8_t> values, const Crop& crop);

/// Edge of a pixel of the (cropped) picture [m]: given directly, by the width, or by the resolution tag of
/// the file, which adds a note.
/// @throws Error without any of them.
[[nodiscard]] double source_pixel_size(const Picture& picture, const ConvertOptions& options,
                                       ConvertReport& report);

/// Name of a method as in the options, e.g. "kmeans".
[[nodiscard]] std::string method_name(Segmentation method);

}  // namespace specimen
