/// A square of pixels and irregular points that flies at 3 and -2 m/s: nothing may strain it. The patch test
/// of Irons for a solver whose points cross cells.
#pragma once

#include <string>

#include "libmpm/problems/method.hpp"

namespace mpm::problems {

struct Patch {
  double strayed = 0;  ///< largest distance of a point from where it belongs, over a cell [-]
  double stress = 0;   ///< largest sum of the amounts of a point's stress, over Young's modulus [-]
  double crossed = 0;  ///< cells that the square has flown along x [-]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};

/// @param cells  along an edge of 0.6 m.
[[nodiscard]] Patch fly_uniformly(const Method& method, int cells = 6, int steps = 150);

}  // namespace mpm::problems
