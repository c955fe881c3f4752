/// Maps with a number or a colour for each grain: whether a map is one, and what is between the grains.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/convert/guess.hpp"

namespace specimen {

/// What the values of an instance map are; an index into the values each, -1 = there is none.
struct GrainMap {
  std::int32_t matrix = -1;           ///< between the grains
  std::int32_t line = -1;             ///< drawn one pixel wide between the regions, as a watershed does
  std::vector<std::int32_t> voids{};  ///< dots in several pieces, without a number for each
};

/// The matrix is the value that touches most of the others, at least half of them, whatever its number is: 0,
/// 1, -1, NaN. A line is thin, touches nearly all others and keeps them apart.
[[nodiscard]] GrainMap understand_grains(const ValueMap& map);

/// Whether there are at least five values beside the matrix, nine in ten of them (almost) in one piece.
[[nodiscard]] bool looks_like_grains(const ValueMap& map);

/// Give the pixels of the line to the regions beside them: matrix where they touch it or part two grains.
void dissolve_line(ValueMap& map, const GrainMap& grains);

}  // namespace specimen
