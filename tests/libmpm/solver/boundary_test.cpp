#include "libmpm/solver/boundary.hpp"

#include <gtest/gtest.h>

#include "libmpm/scene/error.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace boundary_test {

using mpm::Side;
using mpm::Way;

/// 8 x 6 pixels of 1 mm, the lower right quarter of which is empty.
mpm::Scene angle() {
  mpm::Scene scene = samples::mortar_block(6, 8, 1e-3);
  scene.points_per_cell = 1;
  scene.labels.bottomRightCorner(3, 4).setZero();
  scene.fixture.supports = {{{Side::bottom, 0, 2e-3}, true, true}};
  scene.fixture.loads = {{.at = {Side::bottom, 6e-3, 7e-3}, .way = Way::up, .leads = true}};
  return scene;
}

mpm::GridBoundary boundary_of(const mpm::Scene& scene) { return mpm::find_boundary(scene, 8, 6, 1e-3); }

std::string refusal(const mpm::Scene& scene) {
  try {
    (void)boundary_of(scene);
  } catch (const mpm::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Boundary, AStretchIsTheOutlineSeenFromItsSide) {
  const mpm::GridBoundary boundary = boundary_of(angle());
  ASSERT_EQ(boundary.held.size(), 5u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(boundary.held[static_cast<std::size_t>(i)].row, 0);
    EXPECT_EQ(boundary.held[static_cast<std::size_t>(i)].col, i);
  }
  for (int i = 3; i < 5; ++i) {
    const mpm::HeldNode& node = boundary.held[static_cast<std::size_t>(i)];
    EXPECT_EQ(node.row, 3) << "the lower edge of the arm";
    EXPECT_EQ(node.col, i + 3);
    EXPECT_EQ(node.uy, 1);
    EXPECT_EQ(node.load, 0);
    EXPECT_FALSE(node.x);
  }
}

TEST(Boundary, AFlatPlateTouchesTheOutermostLevelOnly) {
  mpm::Scene scene = angle();
  scene.fixture.supports = {{{Side::bottom}, true, true}};
  scene.fixture.loads = {{.at = {Side::top}, .way = Way::up, .leads = true}};
  const mpm::GridBoundary boundary = boundary_of(scene);
  EXPECT_EQ(boundary.held.size(), 5u + 9u);  // columns 0 to 4 of the foot; all of the top
}

TEST(Boundary, APointIsTheNearestNode) {
  mpm::Scene scene = angle();
  scene.fixture.loads[0].at = {Side::right, 4.4e-3, 4.4e-3};
  scene.fixture.loads[0].way = Way::left;
  const mpm::GridBoundary boundary = boundary_of(scene);
  EXPECT_EQ(boundary.held.back().row, 4);
  EXPECT_EQ(boundary.held.back().col, 8);
  EXPECT_EQ(boundary.held.back().ux, -1);
}

TEST(Boundary, WhatCanMoveAsAWholeIsRefused) {
  mpm::Scene scene = angle();
  scene.fixture.supports[0].fix_x = false;
  EXPECT_EQ(refusal(scene),
            "supports: the specimen can slide along x as a whole; supports and loads must hold it along x, "
            "along y and against turning; add x to fix of a support");
  scene.fixture.supports[0] = {{Side::bottom, 0, 0}, true, false};
  scene.fixture.loads[0].at = {Side::bottom, 6e-3, 6e-3};
  EXPECT_NE(refusal(scene).find("can turn as a whole"), std::string::npos) << refusal(scene);
}

TEST(Boundary, TwoMotionsOfANodeAreRefused) {
  mpm::Scene scene = angle();
  scene.fixture.loads[0].at = {Side::bottom, 1e-3, 3e-3};
  EXPECT_NE(refusal(scene).find("loads[1]: meets a node that another support or load moves otherwise"),
            std::string::npos)
      << refusal(scene);
}

TEST(Boundary, AGaugeReadsBetweenNodesAndAtEdges) {
  mpm::Scene scene = angle();
  scene.fixture.gauges = {{"inside", 0.5e-3, 4.5e-3, 1.25e-3, 4.5e-3},
                          {"edge", 4e-3, 1e-3, 4e-3, 3e-3, mpm::Gauge::Direction::x}};
  const mpm::GridBoundary boundary = boundary_of(scene);
  double sum = 0, stretch = 0;
  for (const mpm::NodeWeight& node : boundary.gauges[0]) {
    sum += node.x;
    stretch += node.x * node.col * 1e-3;  // u = x
    EXPECT_EQ(node.y, 0);
  }
  EXPECT_NEAR(sum, 0, 1e-15);
  EXPECT_NEAR(stretch, 0.75e-3, 1e-15);
  EXPECT_EQ(boundary.gauges[1].front().col, 4);
  scene.fixture.gauges = {{"off", 7e-3, 0, 0, 0}};
  EXPECT_NE(refusal(scene).find("is not on the specimen"), std::string::npos) << refusal(scene);
}

}  // namespace boundary_test
