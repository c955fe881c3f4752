/// What lies outside of a specimen that does not fill its picture: round a core, beside a tilted cut.
#pragma once

#include <cstdint>

#include "specimen/body/raster.hpp"
#include "specimen/convert/convert.hpp"

namespace specimen {

/// Pixels outside of the specimen: 1 there, 0 elsewhere; empty where the specimen fills the picture.
using OutsideMask = Raster<std::uint8_t>;

/// What a map shows outside: the pieces of one value that reach at least three corners of the picture (two,
/// if it is black), if what is left is one convex body that is not of one value alone.
/// @param forced  without these conditions: whatever reaches the most corners.   @param black  code; -1 =
/// none.
[[nodiscard]] OutsideMask outside_of_map(const Raster<std::int32_t>& code, bool forced, int black = -1);

/// The same for a photograph: even black or white. Transparent pixels and such without a value (NaN) are
/// always outside.
[[nodiscard]] OutsideMask outside_of_photograph(const Picture& picture, bool forced);

/// Transparent pixels, and those without a value.
[[nodiscard]] OutsideMask without_value(const Picture& picture);

}  // namespace specimen
