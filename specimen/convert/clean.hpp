/// Cleaning of a segmented picture: smooth outlines, no small islands and holes.
#pragma once

#include <array>
#include <cstdint>

#include "specimen/convert/grains.hpp"

namespace specimen {

/// Changes made by a cleaning step.
struct Changed {
  std::int64_t pieces = 0;  ///< islands or holes
  std::int64_t pixels = 0;
};

/// Opening of a phase with a disc: parts that the disc cannot reach inside the phase (spurs, necks, thin
/// strips) join the nearest other phase.   @param radius  of the disc [px].
Changed open_phase(Raster<Cell>& cells, std::uint8_t phase, double radius);

/// Closing of the aggregates with a disc: gaps and bays that the disc cannot enter become aggregate, each
/// pixel of the nearest grain.   @param radius  of the disc [px].
Changed close_aggregates(Raster<Cell>& cells, double radius);

/// Smallest area of a piece [px], by phase label.
using LeastArea = std::array<double, 256>;

/// Pieces smaller than the smallest area of their phase join the neighbour with the longest common boundary;
/// pieces inside small pieces follow. If no piece of the picture is large enough, nothing changes.
Changed drop_islands(Raster<Cell>& cells, const LeastArea& least);

/// Pieces of one phase inside another phase join it if more than `share` of their boundary touches it (the
/// border of the picture does not count) and their area is less than a quarter of its area.   @param share
/// [-].
Changed absorb(Raster<Cell>& cells, std::uint8_t phase, std::uint8_t into, double share);

/// Fill holes that lie completely inside one grain (or piece of aggregate) and do not touch the border of the
/// picture.
Changed fill_holes(Raster<Cell>& cells);

/// Area of the largest piece of aggregate [px].
[[nodiscard]] std::int64_t largest_aggregate(const Raster<Cell>& cells);

}  // namespace specimen
