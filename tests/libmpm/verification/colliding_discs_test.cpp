// Two elastic discs that meet head on and part: contact through the grid.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/moving_scenes.hpp"

namespace {

using samples::Method;
using samples::Moving;

/// Two discs 0.4 m across in a square of 1 m, 20 cells wide, thrown at each other.
mpm::Scene two_discs() {
  mpm::Scene scene = samples::soft_body(40, 40, 0.025, 0.3);
  for (int row = 0; row < 40; ++row)
    for (int col = 0; col < 40; ++col) {
      const double x = col + 0.5;
      const double y = 39.5 - row;
      if (std::hypot(x - 11, y - 11) > 8 && std::hypot(x - 29, y - 29) > 8) scene.labels(row, col) = 0;
    }
  return scene;
}

TEST(CollidingDiscs, Figures) {
  for (const Method& method : samples::all_methods(0.99)) {
    mpm::Scene scene = two_discs();
    method.give_to(scene);
    Moving<double> it(scene);
    it.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
      vx = vy = p.x + p.y < 1 ? 1.5 : -1.5;
    });
    const samples::Sums before = samples::sums_of(it.solver);
    double least = 1e30, most = 0, turned = 0;
    mpm::Ledger ledger;
    while (it.solver.time() < 0.16 && ledger.trouble.empty()) {
      ledger = it.solver.advance(10);
      least = std::min(least, ledger.kinetic + ledger.elastic);
      most = std::max(most, ledger.kinetic + ledger.elastic);
    }
    for (const auto& p : it.solver.points()) {
      const auto rest = it.rest_place(p.id);
      turned += p.mass * (p.vx + p.vy) * (rest.x + rest.y < 1 ? -1 : 1);
    }
    const samples::Sums after = samples::sums_of(it.solver);
    std::printf("%-22s energy %.4f..%.4f end kin %.4f  rebound %.4f  momentum %.1e %s steps %ld\n", method.name().c_str(),
                least / before.kinetic, most / before.kinetic, after.kinetic / before.kinetic,
                turned / (3 * before.mass), std::hypot(after.px, after.py) / (before.mass * 1.5),
                ledger.trouble.c_str(), static_cast<long>(it.solver.steps()));
  }
}

}  // namespace
