/// The picture while it is being cleaned: phases and grains in one raster.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {

/// What a pixel is: a phase label (0 to 255), or a grain of aggregate with a number of its own (above 255).
/// So whatever moves a boundary moves phase and grain together.
using Cell = std::int32_t;

inline constexpr Cell first_grain = 256;

[[nodiscard]] constexpr Cell grain(std::int32_t number) { return first_grain + number; }
[[nodiscard]] constexpr std::uint8_t phase_of(Cell cell) {
  return cell >= first_grain ? phase::aggregate : static_cast<std::uint8_t>(cell);
}
[[nodiscard]] constexpr bool is_aggregate(Cell cell) { return phase_of(cell) == phase::aggregate; }

/// Give every connected piece of aggregate a grain number of its own, 1, 2, ... in reading order. Pixels hang
/// together that share an edge and a grain number (or have none yet); touching at a corner is not enough.
/// @return the number of grains.
int number_grains(Raster<Cell>& cells);

/// Cut grains at their necks: a watershed on the distance to the rim that keeps two summits apart only where
/// the saddle between them lies deeper than `depth` times the lower summit.
/// @param depth  [-], 0 to 1.   @return the number of grains after the cut.
int split_grains(Raster<Cell>& cells, double depth);

/// Numbers of the grains in a raster, rising.
[[nodiscard]] std::vector<std::int32_t> grain_numbers(const Raster<Cell>& cells);

}  // namespace specimen
