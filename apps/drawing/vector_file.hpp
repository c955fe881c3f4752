/// A drawing as a file that can be enlarged without end.
#pragma once

#include <string>

#include "apps/drawing/drawing.hpp"

namespace output {

enum class VectorFormat { svg, pdf };

/// On white paper. A px of the drawing is 3/4 of a point.
/// @param margin  of paper on every side [px of the drawing].
/// @throws std::runtime_error when the drawing library fails (out of memory).
[[nodiscard]] std::string vector_file(const Drawing& drawing, VectorFormat format, double margin);

}  // namespace output
