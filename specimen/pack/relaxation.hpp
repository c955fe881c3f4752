/// Packing of ellipses with given axes: random placement, then relaxation of overlaps until every gap is
/// kept.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/pack/placement.hpp"

namespace specimen {

/// Result of a relaxation.
struct Relaxation {
  bool solved = false;  ///< every gap is kept, by the exact test on the final ellipses
  int sweeps = 0;       ///< over all neighbours
};

/// Whether ellipses may rotate.
enum class Turning {
  free,
  fixed,  ///< every ellipse keeps its angle
};

/// Move and rotate the ellipses until all of them keep the gap.
/// Pairs that are too close are pushed apart along the direction of their gap, at the points that face each
/// other, as rigid bodies with their area as mass: so they rotate as well, and small ones move more. Stops
/// when the overlaps no longer shrink. The work is bounded, and linear in the number of ellipses. In a
/// periodic domain the centres end inside.
[[nodiscard]] Relaxation relax(std::vector<Ellipse>& ellipses, const Room& room,
                               Turning turning = Turning::free);

/// Result of a packing.
struct Settlement {
  bool solved = false;                   ///< every gap is kept
  bool relaxed = false;                  ///< random placement was not enough
  std::optional<std::size_t> too_large;  ///< an ellipse that does not fit between the walls in any direction
};

/// Place ellipses, largest first, each at its first free random position; if some find none, relax all.
/// @param ellipses  axes, and with Turning::fixed angles; largest first; their centres are set.
[[nodiscard]] Settlement settle(std::vector<Ellipse>& ellipses, const Room& room, Turning turning,
                                Random& random);

}  // namespace specimen
