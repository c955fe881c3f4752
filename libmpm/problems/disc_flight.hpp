/// A disc of 0.9 m in free flight with a spin of 10 1/s: momentum and angular momentum stay.
#pragma once

#include <string>

#include "libmpm/problems/moving_body.hpp"

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

}  // namespace mpm::problems
