#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/strength.hpp"
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

}  // namespace lattice_points_test
