#include "libmpm/solver/grid.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/sample_scenes.hpp"

namespace grid_test {

double total_mass(const mpm::Scene& scene) {
  const mpm::Plan plan = mpm::plan(scene);
  const mpm::Grid grid = mpm::make_grid(scene, plan);
  double mass = 0;
  for (const double value : grid.impulse_over_mass)
    if (value > 0) mass += plan.dt / (scene.points_per_cell * scene.points_per_cell * value);
  return mass;
}

TEST(Grid, HoldsTheMassOfTheImage) {
  mpm::Scene scene = samples::small_concrete();
  scene.phases[samples::itz]->density = 1800;
  scene.labels.block(0, 0, 10, 10).setConstant(0);
  double expected = 0;
  for (const auto label : scene.labels.reshaped())
    if (scene.phases[label]) expected += scene.phases[label]->density * 0.25e-6;
  EXPECT_NEAR(total_mass(scene), expected, 1e-12 * expected);
}

// The pixel in row 0, column 1 lies at (0.75, 0.75) of the upper left cell.
TEST(Grid, GivesAPointsMassToTheNodesOfItsCell) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.labels.setConstant(0);
  scene.labels(0, 1) = samples::mortar;
  const mpm::Plan plan = mpm::plan(scene);
  const mpm::Grid grid = mpm::make_grid(scene, plan);
  const double weights[3][3] = {{0, 0, 0}, {0.0625, 0.1875, 0}, {0.1875, 0.5625, 0}};  // row 0 is the bottom
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) {
      const double mass = weights[row][col] * 2400 * 0.25e-6;
      const double expected = mass > 0 ? plan.dt / (4 * mass) : 0;
      EXPECT_NEAR(grid.impulse_over_mass[static_cast<std::size_t>(grid.at(row, col))], expected,
                  1e-12 * expected)
          << "row " << row << ", column " << col;
    }
  }
}

TEST(Grid, ExtraPointsShareTheMassOfTheirPixel) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  const double mass = total_mass(scene);
  scene.extra_points = {
      {1.1e-3, 1.1e-3, samples::itz}, {1.2e-3, 1.2e-3, samples::itz}, {0, 4e-3, samples::itz}};
  EXPECT_NEAR(total_mass(scene), mass, 1e-12 * mass);
}

TEST(Grid, PointsPerPixelFollowTheImageConvention) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  scene.extra_points = {{0.1e-3, 0.1e-3, samples::itz}, {3.9e-3, 3.9e-3, samples::itz}};
  const auto count = mpm::points_per_pixel(scene);
  EXPECT_EQ(count(7, 0), 2) << "the origin is the bottom left corner, row 0 is the top";
  EXPECT_EQ(count(0, 7), 2);
  EXPECT_EQ(count.cast<int>().sum(), 66);
}

TEST(Grid, VoidHasNoMass) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  scene.labels.leftCols(4).setConstant(0);
  const mpm::Grid grid = mpm::make_grid(scene, mpm::plan(scene));
  EXPECT_EQ(grid.impulse_over_mass[static_cast<std::size_t>(grid.at(2, 0))], 0);
  EXPECT_GT(grid.impulse_over_mass[static_cast<std::size_t>(grid.at(2, 3))], 0);
}

}  // namespace grid_test
