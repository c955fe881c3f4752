/// Number of pixels of a specimen to be drawn.
#pragma once

#include <string>

namespace specimen {

struct Canvas {
  int rows = 0, cols = 0;  ///< [px]
};

/// @param width,height  of the specimen [m].   @param group  of the fields in errors: "generate".
/// @throws Error if a size is not positive or not a whole number of pixels, or for too many pixels.
[[nodiscard]] Canvas canvas_of(double width, double height, double pixel_size, const std::string& group);

}  // namespace specimen
