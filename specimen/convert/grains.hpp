/// The picture during cleaning: phases and grains in one raster.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {

/// Value of a pixel: a phase label (0 to 255), or the number of a grain of aggregate (above 255). So a
/// boundary of a phase and of a grain always move together.
using Cell = std::int32_t;

inline constexpr Cell first_grain = 256;

[[nodiscard]] constexpr Cell grain(std::int32_t number) { return first_grain + number; }
[[nodiscard]] constexpr std::uint8_t phase_of(Cell cell) {
  return cell >= first_grain ? phase::aggregate : static_cast<std::uint8_t>(cell);
}
[[nodiscard]] constexpr bool is_aggregate(Cell cell) { return phase_of(cell) == phase::aggregate; }

/// Number the connected pieces of aggregate 1, 2, ... in reading order. Pixels are connected if they share an
/// edge and a grain number (or have none yet); a common corner is not enough.
/// @return the number of grains.
int number_grains(Raster<Cell>& cells);

/// Number the grains anew that are left apart where `cuts` is 1; the pixels of the cuts join the grains
/// beside them.   @param cuts  shape of the cells.   @return the number of grains.
int cut_grains(Raster<Cell>& cells, const Raster<std::uint8_t>& cuts);

/// Give all grains the same number that one connected mark crosses, whether or not they touch.
/// @param marks  1 where there is a mark, shape of the cells; marks that share a corner are connected.
/// @return the number of grains.
int join_grains(Raster<Cell>& cells, const Raster<std::uint8_t>& marks);

/// Cut grains at their necks: a watershed on the distance to the outline that separates two maxima only if
/// the saddle between them is lower than the lower maximum by more than `depth` times this maximum.
/// @param depth  [-], 0 to 1.   @return the number of grains after the cut.
int split_grains(Raster<Cell>& cells, double depth);

/// Numbers of the grains in a raster, increasing.
[[nodiscard]] std::vector<std::int32_t> grain_numbers(const Raster<Cell>& cells);

}  // namespace specimen
