#include "apps/bench/stability_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/bench/stability_scenes.hpp"
#include "libmpm/solver/lattice/cell_limit.hpp"

namespace stability_critical_step_test {

using namespace app::bench;

/// Over the time that a wave takes over a cell [-].
double in_transits(const mpm::Scene& scene) {
  const mpm::Plan plan = mpm::plan(scene);
  const CriticalStep step = critical_step(scene, plan);
  EXPECT_LT(step.uncertainty, 1e-6);
  return step.dt * plan.wave_speed / plan.cell_size;
}

// One cell between the platens can stretch sideways only: omega^2 = 4 c^2 / h^2.
TEST(StabilityCriticalStep, OfOneCellBetweenPlatens) {
  EXPECT_NEAR(in_transits(block(2, 2, elastic())), 1, 1e-9);
}

// Sideways rows of free nodes swing against each other with the same frequency at most.
TEST(StabilityCriticalStep, OfABlockIsThatOfPlaneWaves) {
  EXPECT_NEAR(in_transits(block(16, 16, elastic())), 1, 1e-3);
}

// Rough platens hold all nodes of one cell.
TEST(StabilityCriticalStep, RoughPlatensHoldTheirNodes) {
  mpm::Scene scene = block(4, 2, elastic());
  scene.loading.platen = mpm::Platen::rough;
  // Two nodes between two rows that stand still; mass of half a cell each, stiffness of two cells.
  EXPECT_GT(in_transits(scene), 1.0);
}

TEST(StabilityCriticalStep, IsNoShorterThanTheBoundFromTheCells) {
  mpm::Scene scene = unbreakable(concrete(20, 20));
  for (int i = 0; i < 20; ++i) scene.labels(i, (7 * i) % 20) = 0;
  scene.extra_points = {{3.1e-3, 4.2e-3, third}, {5e-3, 5e-3, third}, {0, 10e-3, third}};
  const mpm::Plan plan = mpm::plan(scene);
  EXPECT_GE(critical_step(scene, plan).dt, mpm::cell_limit(scene, plan));
}

}  // namespace stability_critical_step_test
