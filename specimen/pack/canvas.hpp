/// How many pixels a specimen has that is drawn.
#pragma once

#include <string>

namespace specimen {

struct Canvas {
  int rows = 0, cols = 0;  ///< [px]
};

/// @param width,height  of the specimen [m].   @param group  of the fields in errors: "generate".
/// @throws Error when a size is not positive or no whole number of pixels, and for too many pixels.
[[nodiscard]] Canvas canvas_of(double width, double height, double pixel_size, const std::string& group);

}  // namespace specimen
