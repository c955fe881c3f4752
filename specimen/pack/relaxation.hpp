/// Overlapping ellipses pushed apart until every gap is kept.
/// Ellipses of given axes laid into a room: at random where there is place, pushed apart where there is not.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/raster.hpp"
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

/// What came of laying ellipses into a room.
struct Settlement {
  bool solved = false;                   ///< every gap is kept
  bool relaxed = false;                  ///< plain placement was not enough
  std::optional<std::size_t> too_large;  ///< the ellipse that fits between the walls at no direction tried
};

/// Largest first, each at the first of its random places that is free; if some find none, all are relaxed.
/// @param ellipses  axes, and with Turning::fixed angles; largest first; they get their centres.
[[nodiscard]] Settlement settle(std::vector<Ellipse>& ellipses, const Room& room, Turning turning,
                                Random& random);

}  // namespace specimen
