/// Cleaning a sorted picture: rims made smooth, islands and holes taken up by what is round them.
#pragma once

#include <array>
#include <cstdint>

#include "specimen/convert/grains.hpp"

namespace specimen {

/// What a step of the cleaning changed.
struct Changed {
  std::int64_t pieces = 0;  ///< islands or holes
  std::int64_t pixels = 0;
};

/// Opening of a phase with a disc: what the disc cannot reach inside the phase (spurs, necks, thin strips)
/// goes to the nearest other phase.   @param radius  of the disc [px].
Changed open_phase(Raster<Cell>& cells, std::uint8_t phase, double radius);

/// Closing of the aggregates with a disc: gaps and bays that the disc cannot enter become aggregate, each
/// pixel of the nearest grain.   @param radius  of the disc [px].
Changed close_aggregates(Raster<Cell>& cells, double radius);

/// Least area of a piece [px], by phase label.
using LeastArea = std::array<double, 256>;

/// Pieces smaller than their phase's least area join whatever they share the longest boundary with; pieces
/// inside small pieces follow. Where nothing in the picture is large enough, nothing is changed.
Changed drop_islands(Raster<Cell>& cells, const LeastArea& least);

/// Pieces of one phase that lie in another one, by more than `share` of their boundary (the border of the
/// picture does not count) and under a quarter of the area of what they lie in, join it.   @param share  [-].
Changed absorb(Raster<Cell>& cells, std::uint8_t phase, std::uint8_t into, double share);

/// Fill what lies wholly inside one grain (or piece of aggregate) and does not reach the border of the
/// picture.
Changed fill_holes(Raster<Cell>& cells);

/// Area of the largest piece of aggregate [px].
[[nodiscard]] std::int64_t largest_aggregate(const Raster<Cell>& cells);

}  // namespace specimen
