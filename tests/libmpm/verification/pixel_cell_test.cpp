// What a cell of one pixel is for: thin layers that soften, crack through and then carry nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace pixel_cell_test {

using mpm::Scene;

constexpr double strength = 3e6;

/// Mortar that does not fail, with one weak row of pixels at a height from the top, pulled slowly.
Scene weak_row(int row, bool pixel_cells) {
  Scene scene = samples::unbreakable(samples::mortar_block(12, 8));
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  mpm::Phase weak = *scene.phases[2];
  weak.tensile_scale = strength;
  weak.weibull_modulus = 1e9;  // the same strength everywhere
  scene.phases[samples::aggregate] = weak;
  scene.labels.row(row).setConstant(samples::aggregate);
  scene.pixel_cells = pixel_cells;
  scene.points_per_cell = pixel_cells ? 1 : 2;
  scene.loading.velocity = 0.002;
  scene.loading.stop_strain = 4e-4;
  scene.local_damping = 0.3;
  return scene;
}

double last_stress(const mpm::Result& result) {
  double largest = 0;
  for (auto row = result.history.end() - 20; row != result.history.end(); ++row)
    largest = std::max(largest, std::abs(row->stress));
  return largest;
}

TEST(PixelCell, AWeakRowCarriesItsStrengthAndThenNothing) {
  for (const int row : {4, 5}) {
    const mpm::Result result = mpm::simulate(weak_row(row, true));
    EXPECT_NEAR(result.peak_stress, strength, 0.01 * strength) << row;
    EXPECT_EQ(result.tension_failures, 8) << row;
    EXPECT_LT(last_stress(result), 0.01 * strength) << row;
  }
}

// The paper's cells of 2 x 2 points: half a cell cannot crack through, and goes on carrying.
TEST(PixelCell, InCellsOfFourPointsAWeakRowGoesOnCarrying) {
  const mpm::Result result = mpm::simulate(weak_row(4, false));
  EXPECT_EQ(result.tension_failures, 8);
  EXPECT_GT(last_stress(result), strength);
}

TEST(PixelCell, TheLedgerCloses) {
  for (const mpm::CrackClosure closure : {mpm::CrackClosure::off, mpm::CrackClosure::unilateral})
    for (const double energy : {0.0, 150.0}) {
      Scene scene = samples::small_concrete(40, 40);
      scene.pixel_cells = true;
      scene.points_per_cell = 1;
      scene.loading.velocity = 0.5;
      scene.loading.stop_strain = 1.5e-3;
      scene.damage.crack_closure = closure;
      for (auto& phase : scene.phases)
        if (phase && phase->can_crack()) {
          phase->fracture_energy = energy;
          phase->weibull_modulus = 1.5 + energy / 100;
        }
      const mpm::Result result = mpm::simulate(scene);
      EXPECT_GT(result.tension_failures, 15) << energy;
      const bool conserves = closure == mpm::CrackClosure::off;
      EXPECT_LT(result.energy_error, conserves ? 1e-11 : 2e-2) << energy;
    }
}

TEST(PixelCell, GivesTheSameBitsOnAnyNumberOfThreads) {
  Scene scene = samples::small_concrete(40, 30);
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading.velocity = 0.5;
  scene.threads = 1;
  const mpm::Result one = mpm::simulate(scene);
  scene.threads = 3;
  const mpm::Result three = mpm::simulate(scene);
  EXPECT_EQ(one.peak_stress, three.peak_stress);
  EXPECT_EQ(one.history.back().released, three.history.back().released);
}

}  // namespace pixel_cell_test
