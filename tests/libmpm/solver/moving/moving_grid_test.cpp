#include "libmpm/solver/moving/moving_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace moving_grid_test {

using mpm::Edge;
using mpm::Support;

mpm::Scene body(mpm::Shape shape) {
  mpm::Scene scene = samples::soft_body(12, 8, 0.05);
  scene.motion.shape = shape;
  scene.motion.margin = 0.2;  // two cells
  scene.motion.left = mpm::Edge::symmetry;
  return scene;
}

mpm::MovingGeometry geometry_of(const mpm::Scene& scene) {
  return mpm::moving_geometry(scene, mpm::plan(scene));
}

TEST(MovingGeometry, OfLinearShapesHasACellForATile) {
  const mpm::MovingGeometry geometry = geometry_of(body(mpm::Shape::linear));
  EXPECT_EQ(geometry.cells_x, 4 + 2);  // none at the plane of symmetry
  EXPECT_EQ(geometry.cells_y, 6 + 4);
  EXPECT_EQ(geometry.tiles_x, 6);
  EXPECT_EQ(geometry.tiles_y, 10);
  EXPECT_EQ(geometry.nodes_x, 7);
  EXPECT_EQ(geometry.nodes_y, 11);
  EXPECT_EQ(geometry.reach, 2);
  EXPECT_EQ(geometry.before, 0);
  EXPECT_DOUBLE_EQ(geometry.left, 0);
  EXPECT_DOUBLE_EQ(geometry.bottom, -0.2);
  EXPECT_DOUBLE_EQ(geometry.bottom_of(3), 3);
}

TEST(MovingGeometry, OfQuadraticShapesHasATileRoundEveryNode) {
  for (const auto shape : {mpm::Shape::gimp, mpm::Shape::bspline}) {
    const mpm::MovingGeometry geometry = geometry_of(body(shape));
    EXPECT_EQ(geometry.tiles_x, 7);
    EXPECT_EQ(geometry.tiles_y, 11);
    EXPECT_EQ(geometry.nodes_x, 9);  // one beyond each edge
    EXPECT_EQ(geometry.nodes_y, 13);
    EXPECT_EQ(geometry.reach, 3);
    EXPECT_EQ(geometry.before, 1);
    EXPECT_DOUBLE_EQ(geometry.bottom_of(0), -0.5);
  }
}

TEST(MovingGeometry, ReachesToThePlatensAndNoFurther) {
  mpm::Scene scene = body(mpm::Shape::linear);
  scene.loading.direction = mpm::Direction::compression;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 0.1;
  scene.loading.duration = 0;
  const mpm::MovingGeometry geometry = geometry_of(scene);
  EXPECT_EQ(geometry.cells_y, 6);
  EXPECT_DOUBLE_EQ(geometry.bottom, 0);
}

using Bands = std::vector<int>;  // rows of tiles at which they end

/// Sums of rows of tiles, every row full of a number of its own.
class Sums : public testing::TestWithParam<std::tuple<mpm::Shape, Bands>> {
 protected:
  mpm::MovingGeometry geometry_ = geometry_of(tall_body(std::get<0>(GetParam())));
  Bands ends_ = ends_for(geometry_.tiles_y);
  mpm::TileSums<double> sums_{geometry_, 1, ends_};

  static mpm::Scene tall_body(mpm::Shape shape) {
    mpm::Scene scene = samples::soft_body(60, 8, 0.05);
    scene.motion.shape = shape;
    return scene;
  }
  static Bands ends_for(int tiles_y) {
    Bands ends = std::get<1>(GetParam());
    ends.push_back(tiles_y);
    return ends;
  }

  static double number_of(int row) { return 100 + row; }
  void fill(int row) {
    const mpm::moving::Sums<double> out = sums_.sums(row);
    sums_.mark_filled(row);
    for (int plane = 0; plane < geometry_.reach * geometry_.reach; ++plane)
      std::fill_n(out.values + plane * out.length, geometry_.tiles_x, number_of(row));
  }

  /// The tiles that meet in a row of nodes hold what was written, zeros lie beside them.
  void expect_complete(int node_row) const {
    const mpm::moving::NodeRow<double> nodes = sums_.node_row(node_row);
    for (int b = 0; b < geometry_.reach; ++b) {
      const int row = node_row - b;
      const bool inside = row >= 0 && row < geometry_.tiles_y;
      for (const int tile : {0, geometry_.tiles_x - 1})
        EXPECT_EQ(nodes.tiles[b][tile], inside ? number_of(row) : 0) << node_row << " " << b;
      for (const int beside : {-1, geometry_.tiles_x}) EXPECT_EQ(nodes.tiles[b][beside], 0);
    }
  }
};

// As the solver does it: a band sweeps upwards, and the nodes that it shares with the band below follow when
// all have swept.
TEST_P(Sums, AreThereUntilTheirNodesAreDone) {
  int begin = 0;
  for (const int end : ends_) {
    const int own = begin > 0 ? begin + geometry_.reach - 1 : 0;
    for (int row = begin; row < end; ++row) {
      fill(row);
      if (row >= own) expect_complete(row);
    }
    begin = end;
  }
  begin = 0;
  for (const int end : ends_) {
    for (int row = begin; begin > 0 && row < begin + geometry_.reach - 1; ++row) expect_complete(row);
    begin = end;
  }
  for (int row = geometry_.tiles_y; row < geometry_.nodes_y; ++row) expect_complete(row);
}

TEST_P(Sums, OfARowWithoutPointsAreZero) {
  fill(3);
  sums_.clear(3);
  EXPECT_EQ(sums_.node_row(3).tiles[0][2], 0);
  fill(3);
  EXPECT_EQ(sums_.node_row(3).tiles[0][2], number_of(3)) << "and may be filled again";
}

INSTANTIATE_TEST_SUITE_P(Moving, Sums,
                         testing::Combine(testing::Values(mpm::Shape::linear, mpm::Shape::gimp),
                                          testing::Values(Bands{}, Bands{15}, Bands{2, 4, 20})));

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

}  // namespace moving_grid_test
