// Two elastic discs that meet head on and part: contact through the grid.
#include "libmpm/problems/flights.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/moving_scenes.hpp"

namespace colliding_discs_test {

using samples::Method;

// Momentum stays to rounding. Energy is not made, beyond what crossing cells gives and takes with linear
// shapes, and FLIP keeps most of it with smooth ones; APIC spends some in the contact. The discs part again.
void expect_rebound(mpm::Shape shape) {
  for (const Method& method : samples::all_methods(0.99)) {
    if (method.shape != shape) continue;
    SCOPED_TRACE(method.name());
    const auto it = mpm::problems::collide(method);
    ASSERT_EQ(it.trouble, "");
    if (samples::figures)
      std::printf("%-22s energy at most %.4f, kept %.4f, rebound %.4f\n", method.name().c_str(),
                  it.most_energy, it.kept_energy, it.rebound);
    EXPECT_LT(it.lost_momentum, 1e-9);
    EXPECT_LT(it.most_energy, shape == mpm::Shape::linear ? 1.25 : 1.03);
    if (method.transfer == mpm::Transfer::flip && method.flip_ratio >= 1 && shape == mpm::Shape::gimp) {
      EXPECT_NEAR(it.kept_energy, 1, 0.06);
    }
    EXPECT_GT(it.rebound, method.transfer == mpm::Transfer::apic ? 0.65 : 0.85);
  }
}
TEST(CollidingDiscs, PartAgainWithLinearShapes) { expect_rebound(mpm::Shape::linear); }
TEST(CollidingDiscs, PartAgainWithGimp) { expect_rebound(mpm::Shape::gimp); }
TEST(CollidingDiscs, PartAgainWithBSplines) { expect_rebound(mpm::Shape::bspline); }

}  // namespace colliding_discs_test
