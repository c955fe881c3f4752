/// Segmentation of photographs by strokes, or by what strokes taught before.
#pragma once

#include "specimen/convert/segment.hpp"
#include "specimen/convert/strokes.hpp"

namespace specimen {

/// The strokes that the options name, in the shape of the whole picture; empty with a model.
/// @throws Error if they cannot be read, or have another size.
[[nodiscard]] Strokes strokes_for(const Picture& whole, const ConvertOptions& options);

/// Teach a classifier by the strokes, or read the model of the options, and sort the picture.
/// @throws Error if strokes or model do not fit.
[[nodiscard]] Sorted segment_taught(Picture picture, Strokes strokes, const ConvertOptions& options,
                                    ConvertReport& report);

}  // namespace specimen
