/// Two elastic discs 0.4 m across that meet head on at 2.1 m/s each and part: contact through the grid.
#pragma once

#include <string>

#include "libmpm/problems/method.hpp"

namespace mpm::problems {

struct Collision {
  double most_energy = 0;    ///< the largest total energy over that at the start [-]
  double kept_energy = 0;    ///< total energy at the end over that at the start [-]
  double rebound = 0;        ///< mean speed after over that before, negative when they did not part [-]
  double lost_momentum = 0;  ///< of both together, over the mass [m/s]; 0 at the start
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};

/// @param cells  over the 1 m of the picture, a multiple of 20.
[[nodiscard]] Collision collide(const Method& method, int cells = 20, double cfl = 0.5);

}  // namespace mpm::problems
