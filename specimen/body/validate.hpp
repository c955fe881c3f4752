/// What a specimen must hold to be worth keeping or breaking.
#pragma once

#include <cstdint>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// Sizes beyond which a specimen is refused, whatever memory there is; a file is refused on its header,
/// before any memory is asked for.
inline constexpr std::int64_t max_pixels = 200'000'000;
inline constexpr std::int64_t max_inclusions = 4'000'000;
inline constexpr std::int64_t max_points = 100'000'000;  ///< of all contours, and of all rings

/// Check a specimen: extents, scale, phase names, labels within them, inclusions with ids of their own and
/// finite figures, rings that belong to one of them.
/// @throws Error naming the first thing that is wrong, e.g. "rings[2].inclusion".
void validate(const Specimen& specimen);

}  // namespace specimen
