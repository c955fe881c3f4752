/// Euclidean distances in a picture.
#pragma once

#include <cstdint>

#include "specimen/body/raster.hpp"

namespace specimen {

/// Distance of every pixel with a non-zero value to the nearest pixel with zero, from centre to centre [px];
/// 0 at the zeros themselves. Beyond the borders of the picture lies nothing. Without any zero: larger than
/// the picture.
[[nodiscard]] Raster<float> distance_to_zero(const Raster<std::uint8_t>& mask);

}  // namespace specimen
