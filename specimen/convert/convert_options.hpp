/// Checks of the options of a conversion, and the picture and scale that they select.
#pragma once

#include <string>

#include "specimen/convert/convert.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Check each option by itself and against the method.   @throws Error naming the option.
void check_options(const ConvertOptions& options);

/// The part of the picture that the options keep.   @throws Error when it leaves the picture.
[[nodiscard]] Picture cropped(Picture picture, const Crop& crop);

/// Edge of a pixel of the (cropped) picture [m]: as given, by the width, or by the file's tag, which is
/// noted.
/// @throws Error when there is none of them.
[[nodiscard]] double source_pixel_size(const Picture& picture, const ConvertOptions& options,
                                       ConvertReport& report);

/// "kmeans" and the like, as the options are spelt.
[[nodiscard]] std::string method_name(Segmentation method);

}  // namespace specimen
