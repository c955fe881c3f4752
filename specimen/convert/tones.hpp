/// Pictures in a few flat tones whose edges are soft: resized, rotated, drawn with smooth edges, or JPEG.
#pragma once

#include <cstdint>
#include <optional>

#include "specimen/convert/guess.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// A picture sorted into its tones.
struct TonedMap {
  ValueMap map;
  std::int64_t settled = 0;  ///< pixels between two tones that were given to one of them
};

/// Find the tones, values with flat regions, and give every pixel in between to the nearer of the two tones
/// on its sides, even if its own value happens to be a third one. What lies between no two tones near it,
/// such as a dot too small to have a flat middle, goes to the nearest of all tones. The trace of a gap of a
/// pixel between two stones stays a gap.
/// @return nothing for a picture that is not made of at least two flat tones with edges between them.
[[nodiscard]] std::optional<TonedMap> sort_into_tones(const Picture& picture);

}  // namespace specimen
