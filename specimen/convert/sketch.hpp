/// A picture made small, so that what strokes would teach can be seen at once.
#pragma once

#include "specimen/convert/convert.hpp"

namespace specimen {

/// A picture averaged over squares, and how it is to be converted.
struct Sketch {
  Picture picture;
  int factor = 1;          ///< edge of a square [px of the whole picture]
  int rows = 0, cols = 0;  ///< of the whole picture
};

/// Average a picture over squares, so that at most so many pixels are left.
/// @param most_pixels  [-], > 0.
[[nodiscard]] Sketch sketch_of(const Picture& whole, double most_pixels);

/// What options of a whole picture are for its sketch: lengths in pixels are divided, strokes brought to its
/// pixels. What comes of it is what the whole picture gives, but for what is smaller than a square or so.
/// @param options  with strokes that are lines.
[[nodiscard]] ConvertOptions options_for(const Sketch& sketch, ConvertOptions options);

}  // namespace specimen
