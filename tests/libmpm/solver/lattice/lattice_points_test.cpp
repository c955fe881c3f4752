#include "libmpm/solver/lattice/lattice_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/strength.hpp"
#include "libmpm/solver/threshold.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace lattice_points_test {

template <class Real>
mpm::LatticePoints<Real> points_of(const mpm::Scene& scene, const mpm::Plan& plan) {
  return mpm::make_points<Real>(scene, plan, mpm::StrengthFactors(scene, false));
}

TEST(StoredThreshold, IsNeverAboveTheTrueOne) {
  for (const double stress : {1.0, 3.3e6, 15e6 * std::sqrt(2.0), 1e9 / 3})
    EXPECT_LE(static_cast<double>(mpm::stored_threshold(stress, 0.7)), stress * 0.7);
  for (int i = 1; i < 1000; ++i) {  // rounded to the nearest, half of them would lie above
    const double stress = 1e6 * std::sqrt(i);
    EXPECT_LE(static_cast<double>(mpm::stored_threshold(stress, 1e-14)), stress * 1e-14);
  }
  EXPECT_EQ(mpm::stored_threshold(mpm::Phase::unbreakable, 1), mpm::kernels::unreachable);
  EXPECT_EQ(mpm::stored_threshold(0, 1), 0.0F);
}

TEST(LatticePoints, LieWhereTheImageSays) {
  mpm::Scene scene = samples::mortar_block(4, 6);
  scene.labels(3, 0) = samples::aggregate;  // bottom left pixel: cell (0, 0), plane 0
  scene.labels(0, 5) = samples::itz;        // top right pixel: cell row 1, cell 2, plane 3
  const auto points = points_of<double>(scene, mpm::plan(scene));
  EXPECT_EQ(points.stiffness[points.at(0, 0, 0)], 40e9);
  EXPECT_EQ(points.stiffness[points.at(0, 1, 0)], 20e9);
  EXPECT_EQ(points.stiffness[points.at(1, 3, 2)], 12e9);
  EXPECT_EQ(points.tension[points.at(0, 0, 0)], mpm::kernels::unreachable) << "aggregates are elastic";
}

TEST(LatticePoints, DrawStrengthsFromSeedAndPixelAlone) {
  const mpm::Scene scene = samples::mortar_block(4, 6);
  const mpm::Plan plan = mpm::plan(scene);
  const auto points = points_of<double>(scene, plan);
  const mpm::Phase& mortar = *scene.phases[samples::mortar];
  const double factor =
      mpm::strength_factor(mpm::pixel_random(scene.damage.seed, 1, 4), mortar.weibull_modulus);
  // Row 1 from the top is row 2 from below: upper row of cell row 1's lower half, plane b = 0, a = 0 of
  // cell 2.
  EXPECT_NEAR(points.tension[points.at(1, 0, 2)], 15e6 * factor * plan.cell_size / 20e9,
              1e-6 * 15e6 * factor * plan.cell_size / 20e9);
}

TEST(LatticePoints, ShareThePixelWithExtraPoints) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.extra_points = {{0.2e-3, 0.2e-3, samples::itz}};
  const auto points = points_of<double>(scene, mpm::plan(scene));
  EXPECT_EQ(points.stiffness[points.at(0, 0, 0)], 10e9);
  EXPECT_EQ(points.stiffness[points.at(0, 1, 0)], 20e9);
}

// Several Poisson ratios: stiffness is lambda, and all that is stored is times the share of the pixel.
TEST(LatticePoints, ShareThePixelWithExtraPointsOfAnotherPoissonRatio) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  scene.phases[samples::itz]->poisson = 0.3;
  scene.extra_points = {{0.2e-3, 0.2e-3, samples::itz}};
  const mpm::Plan plan = mpm::plan(scene);
  const auto points = points_of<double>(scene, plan);
  const Eigen::Matrix3d c = mpm::stiffness(*scene.phases[samples::mortar], scene.plane);
  EXPECT_EQ(points.stiffness[points.at(0, 0, 0)], 0.5 * c(0, 1));
  EXPECT_EQ(points.shear[points.at(0, 0, 0)], 0.5 * c(2, 2));
  EXPECT_EQ(points.shear[points.at(0, 1, 0)], c(2, 2));
  EXPECT_DOUBLE_EQ(mpm::threshold_scale(plan, *scene.phases[samples::mortar], 0.5), 0.5 * plan.cell_size);
}

TEST(LatticePoints, PaddingCarriesNothingAndNeverFails) {
  const mpm::Scene scene = samples::mortar_block(4, 6);
  const auto points = points_of<float>(scene, mpm::plan(scene));
  for (int cell = 3; cell < points.stride; ++cell) {
    EXPECT_EQ(points.stiffness[points.at(0, 0, cell)], 0.0F);
    EXPECT_EQ(points.tension[points.at(0, 0, cell)], mpm::kernels::unreachable);
  }
}

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

}  // namespace lattice_points_test
