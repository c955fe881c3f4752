#include "libmpm/support.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/sample_scenes.hpp"

namespace {

using mpm::Edge;
using mpm::Support;

void expect_held(const Support& support, Support::Velocity free, int outward, double normal,
                 double tangential) {
  const auto held = support.held(free, outward);
  EXPECT_EQ(held.normal, normal);
  EXPECT_EQ(held.tangential, tangential);
}

TEST(Support, NothingHoldsNothing) { expect_held({}, {3, 4}, 1, 3, 4); }

TEST(Support, ASymmetryPlaneTakesTheNormalMotionBothWays) {
  const Support plane{.active = true};
  expect_held(plane, {3, 4}, 1, 0, 4);
  expect_held(plane, {-3, 4}, 1, 0, 4);
}

TEST(Support, FromAWallTheSpecimenMayPart) {
  for (const int outward : {-1, 1}) {
    const Support smooth{.active = true, .separates = true};
    expect_held(smooth, {outward * 3.0, 4}, outward, 0, 4);
    expect_held(smooth, {outward * -3.0, 4}, outward, outward * -3.0, 4);
    const Support rough{.active = true, .separates = true, .rough = true};
    expect_held(rough, {outward * 3.0, 4}, outward, 0, 0);
    expect_held(rough, {outward * -3.0, 4}, outward, outward * -3.0, 4);
  }
}

TEST(Support, AMovingPlatenGivesItsVelocityAndPartsByTheDifference) {
  const Support platen{.active = true, .separates = true, .velocity = -2};
  expect_held(platen, {0, 1}, 1, -2, 1);   // the platen comes down on it
  expect_held(platen, {-3, 1}, 1, -3, 1);  // it falls faster than the platen
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

}  // namespace
