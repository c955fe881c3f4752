/// Problems with a known answer: bodies in free flight.
/// A disc of 0.9 m in free flight with a spin of 10 1/s: momentum and angular momentum stay.
/// A square of pixels and irregular points that flies at 3 and -2 m/s: nothing may strain it. The patch test
/// of Irons for a solver whose points cross cells.
/// Two elastic discs 0.4 m across that meet head on at 2.1 m/s each and part: contact through the grid.
#pragma once

#include <string>

#include "libmpm/problems/method.hpp"

namespace mpm::problems {

[[nodiscard]] Scene flying_disc(int cells);  ///< @param cells  over the 1 m of its picture

/// Flight at 3 and 2 m/s times `flight`, with a spin [1/s] about the middle.
template <class Real>
void throw_disc(Moving<Real>& it, double spin, double flight = 1) {
  it.solver.kick([&](const PointView& p, double& vx, double& vy) {
    vx = 3 * flight - spin * (p.y - 0.5);
    vy = 2 * flight + spin * (p.x - 0.5);
  });
}

struct Flight {
  double lost_spin = 0;      ///< share of the angular momentum of the spin that a turn of 1.2 rad loses [-]
  double lost_momentum = 0;  ///< share of the momentum that went meanwhile [-]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};
[[nodiscard]] Flight fly(const Method& method, int cells, double cfl = 0.5);

struct Patch {
  double strayed = 0;  ///< largest distance of a point from where it belongs, over a cell [-]
  double stress = 0;   ///< largest sum of the amounts of a point's stress, over Young's modulus [-]
  double crossed = 0;  ///< cells that the square has flown along x [-]
  Cost cost;
  std::string trouble;  ///< empty: it came to its end
};

/// @param cells  along an edge of 0.6 m.
[[nodiscard]] Patch fly_uniformly(const Method& method, int cells = 6, int steps = 150);

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
