#include "libmpm/solver/quasi_static/equilibrium.hpp"

#include <gtest/gtest.h>

#include "libmpm/scene/phase.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace equilibrium_test {

using mpm::Equilibrium;
using mpm::Scene;

Scene with_cells(Scene scene, int points) {
  scene.pixel_cells = points == 0;
  scene.points_per_cell = std::max(1, points);
  scene.method = mpm::SolverMethod::quasi_static;
  return scene;
}

double modulus(const Scene& scene, bool* solved = nullptr) {
  Equilibrium equilibrium(scene, mpm::plan(scene), mpm::StrengthFactors(scene, false));
  const bool ok = equilibrium.solve(0);
  EXPECT_TRUE(ok);
  if (solved != nullptr) *solved = ok;
  EXPECT_NEAR(equilibrium.modulus_top(), equilibrium.modulus_bottom(), 1e-6 * equilibrium.modulus());
  return equilibrium.modulus();
}

TEST(Equilibrium, AUniformBlockHasTheModulusOfItsPhase) {
  for (const int points : {0, 1, 2, 3, 4})
    for (const double poisson : {0.0, 0.2, 0.4999}) {
      if (points == 1 && poisson > 0.4)
        continue;  // one point alone resists neither bending nor its own modes
      Scene scene = with_cells(samples::unbreakable(samples::mortar_block(24, 36)), points);
      scene.phases[2]->poisson = poisson;
      const double expected = scene.phases[2]->young / (1 - poisson * poisson);
      EXPECT_NEAR(modulus(scene), expected, 1e-6 * expected) << points << " " << poisson;
    }
}

TEST(Equilibrium, RoughPlatensMakeABlockStiffer) {
  Scene scene = with_cells(samples::unbreakable(samples::mortar_block(24, 24)), 0);
  const double smooth = modulus(scene);
  scene.loading.platen = mpm::Platen::rough;
  EXPECT_GT(modulus(scene), 1.002 * smooth);
}

/// Layers of one phase twice as stiff, without Poisson's effect.
Scene layers(int offset, int thickness, bool across) {
  Scene scene = with_cells(samples::unbreakable(samples::mortar_block(20, 24)), 0);
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  scene.phases[samples::aggregate]->young = 2 * scene.phases[2]->young;
  if (across)
    scene.labels.middleRows(offset, thickness).setConstant(samples::aggregate);
  else
    scene.labels.middleCols(offset, thickness).setConstant(samples::aggregate);
  return scene;
}

TEST(Equilibrium, ThinLayersAreExactInBothDirections) {
  for (int thickness = 1; thickness <= 3; ++thickness)
    for (int offset = 0; offset < 6; ++offset) {
      const double young = layers(0, 1, true).phases[2]->young;
      const double reuss = young / (1 - 0.5 * thickness / 20);
      const double voigt = young * (1 + thickness / 24.0);
      EXPECT_NEAR(modulus(layers(offset, thickness, true)), reuss, 1e-6 * reuss) << offset;
      EXPECT_NEAR(modulus(layers(offset, thickness, false)), voigt, 1e-6 * voigt) << offset;
    }
}

// Poisson's ratios that differ need the kernels for any material; the sides are free.
TEST(Equilibrium, LiesBetweenTheBoundsForTwoPoissonRatios) {
  Scene scene = with_cells(samples::unbreakable(samples::small_concrete(40, 40)), 0);
  scene.phases[samples::aggregate]->poisson = 0.1;
  const double found = modulus(scene);
  EXPECT_GT(found, scene.phases[3]->young);
  EXPECT_LT(found, scene.phases[samples::aggregate]->young);
}

TEST(Equilibrium, HoldsWithAContrastOfAMillionAndHoles) {
  Scene scene = with_cells(samples::unbreakable(samples::small_concrete(60, 45)), 0);
  scene.phases[samples::aggregate]->young = 1e6 * scene.phases[2]->young;
  scene.labels.block(20, 10, 7, 9).setZero();
  scene.labels.block(40, 0, 3, 30).setZero();
  bool solved = false;
  EXPECT_GT(modulus(scene, &solved), 0);
  EXPECT_TRUE(solved);
}

// Cells that lock are too stiff; those of one pixel do not, and are solved for as well.
TEST(Equilibrium, OfPixelCellsDoesNotLock) {
  const auto of = [](int points, double poisson) {
    Scene scene = with_cells(samples::unbreakable(samples::small_concrete(48, 48)), points);
    for (auto& phase : scene.phases)
      if (phase) phase->poisson = poisson;
    return modulus(scene);
  };
  EXPECT_LT(of(0, 0.4999) / of(0, 0.45), 1.10);
  EXPECT_GT(of(2, 0.4999) / of(2, 0.45), 1.12);
}

TEST(Equilibrium, NeedsAFewIterationsWhateverTheNumberOfPixels) {
  for (const int pixels : {40, 80, 160}) {
    const Scene scene = with_cells(samples::unbreakable(samples::small_concrete(pixels, pixels)), 2);
    Equilibrium equilibrium(scene, mpm::plan(scene), mpm::StrengthFactors(scene, false));
    ASSERT_TRUE(equilibrium.solve(0));
    EXPECT_LT(equilibrium.iterations(), 20) << pixels;
  }
}

// What is updated cell by cell is what a new start gives, bit for bit; whatever the number of cells, and up
// to the last one.
TEST(Equilibrium, FollowsChangesOfItsPoints) {
  for (const auto& [width, height] : {std::pair{36, 28}, {37, 29}, {75, 46}, {23, 61}}) {
    const Scene scene = with_cells(samples::unbreakable(samples::small_concrete(width, height)), 0);
    const auto rows = static_cast<int>(scene.labels.rows());
    const auto cols = static_cast<int>(scene.labels.cols());
    const mpm::Plan plan = mpm::plan(scene);
    const mpm::StrengthFactors factors(scene, false);
    Equilibrium one(scene, plan, factors);
    Equilibrium two(scene, plan, factors);
    Equilibrium anew(scene, plan, factors);
    std::vector<Equilibrium::Change> changes;
    for (int cell = 3; cell < cols; ++cell) changes.push_back({{rows / 2, 0, cell}, 1e-6});
    for (int row = rows / 2; row < rows; ++row) changes.push_back({{row, 0, cols - 1}, 1e-6});
    for (int cell = cols / 2; cell < cols; ++cell) changes.push_back({{rows - 1, 0, cell}, 1e-6});
    one.change(changes);
    for (const Equilibrium::Change& change : changes) two.change({change});
    ASSERT_TRUE(anew.restore(one.all_points()));
    for (Equilibrium* each : {&one, &two, &anew}) ASSERT_TRUE(each->solve(0));
    EXPECT_EQ(one.modulus(), two.modulus());
    EXPECT_EQ(one.modulus(), anew.modulus());
    EXPECT_LT(one.modulus(), 0.7 * modulus(scene));
  }
}

TEST(Equilibrium, HasTheSameBitsOnAnyNumberOfThreads) {
  for (const int points : {0, 2})
    for (const int rows : {128, 131}) {
      if (points == 2 && rows % 2 == 1) continue;
      Scene scene = with_cells(samples::unbreakable(samples::small_concrete(2 * rows, 256)), points);
      const auto displacements = [&](int threads) {
        scene.threads = threads;
        Equilibrium equilibrium(scene, mpm::plan(scene), mpm::StrengthFactors(scene, false));
        EXPECT_TRUE(equilibrium.solve(1e-4));
        return equilibrium.displacements();
      };
      const mpm::NodeField one = displacements(1);
      for (const int threads : {2, 3, 4}) {
        const mpm::NodeField several = displacements(threads);
        EXPECT_TRUE(several.x == one.x && several.y == one.y) << threads << " threads, " << points;
      }
    }
}

}  // namespace equilibrium_test
