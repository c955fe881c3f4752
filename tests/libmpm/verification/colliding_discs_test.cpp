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

// Momentum stays to rounding. Energy is not made, beyond what crossing cells gives and takes with linear
// shapes, and FLIP keeps most of it with smooth ones; APIC spends some in the contact. The discs part again.
void expect_rebound(mpm::Shape shape) {
  for (const Method& method : samples::all_methods(0.99)) {
    if (method.shape != shape) continue;
    SCOPED_TRACE(method.name());
    mpm::Scene scene = two_discs();
    method.give_to(scene);
    Moving<double> it(scene);
    it.solver.kick(
        [](const mpm::PointView& p, double& vx, double& vy) { vx = vy = p.x + p.y < 1 ? 1.5 : -1.5; });
    const samples::Sums before = samples::sums_of(it.solver);
    double most = 0, rebound = 0;
    mpm::Ledger ledger;
    while (it.solver.time() < 0.16 && ledger.trouble.empty()) {
      ledger = it.solver.advance(10);
      most = std::max(most, (ledger.kinetic + ledger.elastic) / before.kinetic);
    }
    ASSERT_EQ(ledger.trouble, "");
    for (const auto& p : it.solver.points()) {
      const auto rest = it.rest_place(p.id);
      rebound += p.mass * (p.vx + p.vy) * (rest.x + rest.y < 1 ? -1 : 1) / (3 * before.mass);
    }
    const samples::Sums after = samples::sums_of(it.solver);
    const double kept = (ledger.kinetic + ledger.elastic) / before.kinetic;
    if (samples::figures)
      std::printf("%-22s energy at most %.4f, kept %.4f, rebound %.4f\n", method.name().c_str(), most, kept,
                  rebound);
    EXPECT_LT(std::hypot(after.px, after.py), 1e-9 * before.mass);
    EXPECT_LT(most, shape == mpm::Shape::linear ? 1.25 : 1.03);
    if (method.transfer == mpm::Transfer::flip && method.flip_ratio >= 1 && shape == mpm::Shape::gimp) {
      EXPECT_NEAR(kept, 1, 0.06);
    }
    EXPECT_GT(rebound, method.transfer == mpm::Transfer::apic ? 0.65 : 0.85);
  }
}
TEST(CollidingDiscs, PartAgainWithLinearShapes) { expect_rebound(mpm::Shape::linear); }
TEST(CollidingDiscs, PartAgainWithGimp) { expect_rebound(mpm::Shape::gimp); }
TEST(CollidingDiscs, PartAgainWithBSplines) { expect_rebound(mpm::Shape::bspline); }

}  // namespace
