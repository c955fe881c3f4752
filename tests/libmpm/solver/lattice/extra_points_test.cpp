#include "libmpm/solver/lattice/lattice_points.hpp"

#include <gtest/gtest.h>

#include "libmpm/material/strength.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace extra_points_test {

const Eigen::Matrix3d mortar = mpm::stiffness(mpm::concrete_phases()[1], mpm::Plane::strain);
constexpr double h = 1e-3;

/// Displacements of a cell in a field of constant strain.
mpm::CellDisplacement constant_strain(double exx, double eyy, double gxy) {
  mpm::CellDisplacement u{};
  for (int node = 0; node < 4; ++node) {
    const double x = (node % 2) * h;
    const double y = (node / 2) * h;
    u.ux[node] = exx * x + gxy * y;
    u.uy[node] = eyy * y;
  }
  return u;
}

TEST(StressInCell, OfAConstantStrainIsTheSameEverywhere) {
  const Eigen::Vector3d expected = mortar * Eigen::Vector3d(1e-4, -2e-4, 3e-4);
  for (const double xi : {0.0, 0.3, 1.0}) {
    const auto s = mpm::stress_in_cell(mortar, constant_strain(1e-4, -2e-4, 3e-4), xi, 1 - xi, h);
    EXPECT_NEAR(s.xx, expected(0), 1);
    EXPECT_NEAR(s.yy, expected(1), 1);
    EXPECT_NEAR(s.xy, expected(2), 1);
  }
}

// Virtual work: the forces on the nodes times any displacement are minus the stress times its strain.
TEST(ForcesInCell, DoTheWorkOfTheStress) {
  const mpm::Stress<double> stress{3, -2, 1};
  const auto f = mpm::forces_in_cell(stress, 0.2, 0.7, 1.0);
  const auto u = constant_strain(0.5, 0.25, 2);
  double work = 0;
  double total_x = 0;
  double total_y = 0;
  for (int node = 0; node < 4; ++node) {
    work += f.x[node] * u.ux[node] + f.y[node] * u.uy[node];
    total_x += f.x[node];
    total_y += f.y[node];
  }
  EXPECT_NEAR(work, -h * (3 * 0.5 - 2 * 0.25 + 1 * 2), 1e-15);
  EXPECT_NEAR(total_x, 0, 1e-15);
  EXPECT_NEAR(total_y, 0, 1e-15);
}

TEST(ExtraPoints, AreSortedByRowsOfCellsAndLieInsideThem) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  scene.extra_points = {{4e-3, 4e-3, samples::itz}, {0, 0, samples::itz}, {1.5e-3, 2.5e-3, samples::itz}};
  const auto extra = mpm::make_extra_points(scene, mpm::plan(scene));
  ASSERT_EQ(extra.points.size(), 3U);
  EXPECT_EQ(extra.row_begin, (std::vector<std::size_t>{0, 1, 1, 2, 3}));
  EXPECT_EQ(extra.points[0].index, 1U);
  EXPECT_EQ(extra.points[1].index, 2U);
  EXPECT_NEAR(extra.points[1].xi, 0.5, 1e-12);
  EXPECT_NEAR(extra.points[1].eta, 0.5, 1e-12);
  EXPECT_EQ(extra.points[2].cell, 3) << "a point on the edge belongs to the last cell";
  EXPECT_NEAR(extra.points[2].xi, 1, 1e-12);
  EXPECT_EQ(extra.points[0].share, 0.5);
}

TEST(ExtraPoints, HaveStrengthsOfTheirOwn) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  scene.extra_points = {
      {1e-3, 1e-3, samples::itz}, {2e-3, 1e-3, samples::itz}, {2e-3, 2e-3, samples::aggregate}};
  const auto extra = mpm::make_extra_points(scene, mpm::plan(scene));
  for (const auto& point : extra.points) {
    const double random = mpm::uniform_random(scene.damage.seed, point.index, 1);
    const bool elastic = point.index == 2;
    EXPECT_EQ(point.state.factor, elastic ? 1 : mpm::strength_factor(random, 1.5));
  }
}

TEST(ExtraPoints, OfVoidAreLeftOut) {
  mpm::Scene scene = samples::mortar_block(8, 8);
  scene.extra_points = {{1e-3, 1e-3, 0}};
  EXPECT_TRUE(mpm::make_extra_points(scene, mpm::plan(scene)).points.empty());
}

}  // namespace extra_points_test
