/// Overlapping ellipses pushed apart until every gap is kept.
#pragma once

#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/pack/placement.hpp"

namespace specimen {

/// What a relaxation came to.
struct Relaxation {
  bool solved = false;  ///< every gap is kept, by the exact test on the ellipses handed back
  int sweeps = 0;       ///< over all neighbours
};

/// Whether ellipses may be turned.
enum class Turning {
  free,
  fixed,  ///< every ellipse keeps its angle
};

/// Move and turn the ellipses until all of them keep the gap of the room.
/// Pairs that come too near are pushed apart along the direction of their gap, at the points that face each
/// other, as if they were rigid and weighed their area: so they turn as well, and small ones give way. Stops
/// when the overlaps no longer shrink. The work is bounded, and linear in the number of ellipses.
/// In a periodic room the centres end inside.
[[nodiscard]] Relaxation relax(std::vector<Ellipse>& ellipses, const Room& room,
                               Turning turning = Turning::free);

}  // namespace specimen
