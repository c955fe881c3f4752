/// Versions of the picture libraries; and the autocorrelation of a picture by the Fourier transform of
/// OpenCV.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// Names and versions of the loaded libraries, e.g. {"OpenCV", "4.6.0"}.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> image_libraries();

/// Number of pairs of set pixels of which the second lies (down, right) of the first, without wrapping round.
/// @param set  0 or 1 per pixel; not empty.   @param most  largest shift along either axis [px].
/// @return shape (most + 1, 2 most + 1): (down, most + right) holds the pairs of that shift. Exact.
[[nodiscard]] Raster<std::int64_t> count_pairs(const Raster<std::uint8_t>& set, int most);

}  // namespace specimen
