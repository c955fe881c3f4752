/// Connected pieces of a picture: pixels of one value that hang together.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// Which neighbours hang together.
enum class Connectivity {
  edges,    ///< the 4 that share an edge
  corners,  ///< the 8 that share an edge or a corner
};

/// Pieces of equal value, numbered 0, 1, ... in the order in which they are met row by row.
struct Components {
  Raster<std::int32_t> piece;      ///< number of the piece per pixel
  std::vector<std::int64_t> area;  ///< [px] per piece
  [[nodiscard]] int count() const { return static_cast<int>(area.size()); }
};

[[nodiscard]] Components connected_pieces(const Raster<std::int32_t>& values, Connectivity connectivity);
[[nodiscard]] Components connected_pieces(const Raster<std::uint8_t>& values, Connectivity connectivity);

}  // namespace specimen
