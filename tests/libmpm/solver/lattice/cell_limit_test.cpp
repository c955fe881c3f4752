#include "libmpm/solver/lattice/cell_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace cell_limit_test {

double limit_over_transit(const mpm::Scene& scene) {
  const mpm::Plan plan = mpm::plan(scene);
  return mpm::cell_limit(scene, plan) * plan.wave_speed / plan.cell_size;
}

/// (lambda + 2 mu) / (lambda + mu), in plane strain.
double stretch_ratio(double poisson) { return 2 * (1 - poisson); }

// A full cell alone swings fastest when it stretches both ways at once: omega^2 = 8 (lambda + mu) / (rho
// h^2).
TEST(CellLimit, OfAFullCellIsThatOfItsSwellingBothWays) {
  for (const double poisson : {0.0, 0.2, 0.45}) {
    mpm::Scene scene = samples::mortar_block(2, 2);
    scene.phases[samples::mortar]->poisson = poisson;
    // With nu = 0 shear of a cell with 2 x 2 points is no faster.
    EXPECT_NEAR(limit_over_transit(scene), 2 * std::sqrt(stretch_ratio(poisson) / 8), 1e-12) << poisson;
  }
}

// A point alone stands a quarter inside: its nodes weigh w_i m, and the sum of (dw_i/dx)^2 / w_i is 16/3.
TEST(CellLimit, OfAPointAloneIsShorter) {
  mpm::Scene scene = samples::mortar_block(2, 2);
  scene.labels.setConstant(0);
  scene.labels(1, 0) = samples::mortar;
  EXPECT_NEAR(limit_over_transit(scene), 2 * std::sqrt(stretch_ratio(0.2) / (2 * 16.0 / 3)), 1e-12);
}

TEST(CellLimit, DoesNotDependOnTheStepOfThePlan) {
  const mpm::Scene scene = samples::small_concrete(20, 20);
  mpm::Plan plan = mpm::plan(scene);
  const double limit = mpm::cell_limit(scene, plan);
  plan.dt *= 3;
  EXPECT_DOUBLE_EQ(mpm::cell_limit(scene, plan), limit);
}

TEST(CellLimit, ExtraPointsOfTheSamePhaseInTheMiddleOfTheirPixelsChangeNothing) {
  mpm::Scene scene = samples::mortar_block(4, 4);
  const double plain = limit_over_transit(scene);
  for (int row = 0; row < 4; ++row)
    for (int col = 0; col < 4; ++col)
      scene.extra_points.push_back({(col + 0.5) * 0.5e-3, (row + 0.5) * 0.5e-3, samples::mortar});
  EXPECT_NEAR(limit_over_transit(scene), plain, 1e-12);
}

// Below the limit nothing grows, whatever the picture.
TEST(CellLimit, IsStable) {
  mpm::Scene scene = samples::unbreakable(samples::small_concrete(20, 20));
  for (int i = 0; i < 20; ++i) scene.labels(i, (7 * i) % 20) = 0;
  scene.loading.ramp_time = 0;
  mpm::Plan plan = mpm::plan(scene);
  plan.dt = 0.999 * mpm::cell_limit(scene, plan);
  plan.steps = 20'000;
  EXPECT_NO_THROW((void)mpm::simulate(scene, plan));
}

}  // namespace cell_limit_test
