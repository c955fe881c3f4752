#include "libmpm/problems/colliding_discs.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/problems/moving_body.hpp"

namespace mpm::problems {
namespace {

Scene two_discs(int cells) {
  const int pixels = 2 * cells;
  Scene scene = soft_body(pixels, pixels, 1.0 / pixels, 0.3);
  for (int row = 0; row < pixels; ++row)
    for (int col = 0; col < pixels; ++col) {
      const double x = (col + 0.5) / pixels;
      const double y = 1 - (row + 0.5) / pixels;
      if (std::hypot(x - 0.275, y - 0.275) > 0.2 && std::hypot(x - 0.725, y - 0.725) > 0.2)
        scene.labels(row, col) = 0;
    }
  return scene;
}

template <class Real>
Collision collide_in(const Scene& scene) {
  constexpr double speed = 1.5;  // along each axis [m/s]
  Moving<Real> it(scene);
  it.solver.kick(
      [](const PointView& p, double& vx, double& vy) { vx = vy = p.x + p.y < 1 ? speed : -speed; });
  const Sums before = sums_of(it.solver);
  Collision outcome;
  Ledger ledger;
  while (it.solver.time() < 0.16 && ledger.trouble.empty()) {
    ledger = it.advance(10);
    outcome.most_energy = std::max(outcome.most_energy, (ledger.kinetic + ledger.elastic) / before.kinetic);
  }
  for (const auto& p : it.solver.points()) {
    const Place rest = it.rest_place(p.id);
    outcome.rebound += p.mass * (p.vx + p.vy) * (rest.x + rest.y < 1 ? -1 : 1) / (2 * speed * before.mass);
  }
  const Sums after = sums_of(it.solver);
  outcome.kept_energy = (ledger.kinetic + ledger.elastic) / before.kinetic;
  outcome.lost_momentum = std::hypot(after.px, after.py) / before.mass;
  outcome.cost = it.meter.cost();
  outcome.trouble = ledger.trouble;
  return outcome;
}

}  // namespace

Collision collide(const Method& method, int cells, double cfl) {
  Scene scene = two_discs(cells);
  scene.cfl = cfl;
  method.give_to(scene);
  return in_precision(method, [&](auto real) { return collide_in<decltype(real)>(scene); });
}

}  // namespace mpm::problems
