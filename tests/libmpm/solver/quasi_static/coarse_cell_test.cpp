#include "libmpm/solver/quasi_static/coarse_cell.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/sample_scenes.hpp"

namespace coarse_cell_test {

using mpm::CellStiffness;

CellStiffness some_cell() {
  const Eigen::Matrix3d c = mpm::stiffness(*samples::mortar_block(4, 4).phases[2], mpm::Plane::strain);
  return mpm::point_stiffness(c, 0.3, 0.6) + 2 * mpm::point_stiffness(c, 0.8, 0.1) + mpm::bending_matrix(c);
}

TEST(CoarseCell, IsTheSameByModesAndByNodes) {
  const CellStiffness cell = some_cell();
  const CellStiffness again = mpm::by_nodes(mpm::by_modes(cell, 1), 1);
  EXPECT_LT((again - cell).norm(), 1e-12 * cell.norm());
  for (int corner = 0; corner < 4; ++corner) {
    const mpm::NodeStiffness by_nodes = mpm::at_corner(cell, corner);
    const mpm::NodeStiffness by_modes = mpm::at_corner(mpm::by_modes(cell, 1), 1, corner);
    EXPECT_NEAR(by_modes.xx, by_nodes.xx, 1e-12 * cell.norm());
    EXPECT_NEAR(by_modes.xy, by_nodes.xy, 1e-12 * cell.norm());
    EXPECT_NEAR(by_modes.yy, by_nodes.yy, 1e-12 * cell.norm());
  }
}

// A coarse cell of two equal children and one that is longer, as at the end of a row of five.
TEST(CoarseCell, JoinsChildrenOfAnyWidthByModesAsByNodes) {
  CellStiffness by_nodes = CellStiffness::Zero();
  mpm::CellModes by_modes = mpm::CellModes::Zero();
  const double ends[] = {0, 2, 4, 7};  // along x; 4 along y
  const double slant = 4.0 / 7;
  for (int child = 0; child < 3; ++child)
    for (int half = 0; half < 2; ++half) {
      const double of_child = 2 / (ends[child + 1] - ends[child]);
      // Any matrix that resists nothing but strain.
      const mpm::CellModes fine = (1 + child + 3 * half) * mpm::by_modes(some_cell(), 1);
      const mpm::ChildWeights weights =
          mpm::child_weights({ends[child] / 7, ends[child + 1] / 7}, {0.5 * half, 0.5 * (half + 1)});
      mpm::add_child(by_nodes, mpm::by_nodes(fine, of_child), weights, mpm::HeldNodes());
      mpm::add_child(by_modes, fine, mpm::child_modes(weights, of_child, slant));
    }
  EXPECT_LT((mpm::by_nodes(by_modes, slant) - by_nodes).norm(), 1e-12 * by_nodes.norm());
}

}  // namespace coarse_cell_test
