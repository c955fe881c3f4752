#include "libmpm/solver/moving/moving_grid.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/sample_scenes.hpp"

namespace support_test {

using mpm::Edge;
using mpm::Support;

void expect_held(const std::optional<Support::Held>& held, double velocity, double before) {
  ASSERT_TRUE(held.has_value());
  EXPECT_EQ(held->velocity, velocity);
  EXPECT_EQ(held->before, before);
}

TEST(Support, NothingHoldsNothing) { EXPECT_FALSE(Support{}.caught(3, 4, 1, true)); }

TEST(Support, APlaneOfSymmetryStandsStillWhateverThePointsBring) {
  const Support plane{.active = true};
  for (const double brought : {-3.0, 3.0})
    for (const bool touched : {false, true}) expect_held(plane.caught(brought, 1, 1, touched), 0, 0);
}

TEST(Support, AMovingPlatenGivesItsVelocityAndItsChange) {
  const Support platen{.active = true, .velocity = 5, .before = 4};
  expect_held(platen.caught(1, -7, 1, true), 5, 4);
}

TEST(Support, AWallCatchesWhatComesAndLetsGoWhatItDoesNotPush) {
  const Support wall{.active = true, .separates = true};
  for (const int outward : {-1, 1}) {
    expect_held(wall.caught(outward * 2.0, 0, outward, false), 0, outward * 2.0);
    EXPECT_FALSE(wall.caught(outward * -2.0, 0, outward, false));
    // In touch, the forces decide, though the points behind already move away.
    expect_held(wall.caught(outward * -2.0, outward * 0.5, outward, true), 0, 0);
    EXPECT_FALSE(wall.caught(outward * -2.0, outward * -0.5, outward, true));
    // What carries no force any more is stopped as if it came anew.
    expect_held(wall.caught(outward * 2.0, 0, outward, true), 0, outward * 2.0);
  }
}

TEST(Supports, OfASceneWithPlatensAreThePlatensAboveAndBelow) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.loading.platen = mpm::Platen::rough;
  scene.loading.separation = true;
  scene.motion.left = Edge::symmetry;
  scene.motion.bottom = Edge::open;  // without meaning beside a platen
  const mpm::Supports supports = mpm::supports_of(scene);
  EXPECT_TRUE(supports.left.active && !supports.left.separates && !supports.left.rough);
  EXPECT_FALSE(supports.right.active);
  for (const Support& platen : {supports.bottom, supports.top})
    EXPECT_TRUE(platen.active && platen.separates && platen.rough);
}

TEST(Supports, OfASceneInFlightAreItsEdges) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.loading.direction = mpm::Direction::none;
  scene.motion.left = Edge::smooth_wall;
  scene.motion.right = Edge::rough_wall;
  scene.motion.bottom = Edge::open;
  scene.motion.top = Edge::closed;
  const mpm::Supports supports = mpm::supports_of(scene);
  EXPECT_TRUE(supports.left.active && supports.left.separates && !supports.left.rough);
  EXPECT_TRUE(supports.right.active && supports.right.separates && supports.right.rough);
  EXPECT_FALSE(supports.bottom.active || supports.top.active);
}

}  // namespace support_test
