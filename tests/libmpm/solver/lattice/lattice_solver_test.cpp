#include "libmpm/solver/lattice/lattice_solver.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/sample_scenes.hpp"

namespace lattice_solver_test {

template <class Real>
class LatticeSolver : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LatticeSolver, Precisions);

TYPED_TEST(LatticeSolver, DoesNotDependOnHowStepsAreGrouped) {
  const mpm::Scene scene = samples::pulled(samples::small_concrete(20, 20));
  const mpm::Plan plan = mpm::plan(scene);
  mpm::LatticeSolver<TypeParam> at_once(scene, plan);
  mpm::LatticeSolver<TypeParam> one_by_one(scene, plan);
  const mpm::Ledger expected = at_once.advance(600);
  mpm::Ledger ledger;
  for (int i = 0; i < 600; ++i) ledger = one_by_one.advance(1);
  EXPECT_EQ(ledger.force_top, expected.force_top);
  EXPECT_EQ(ledger.platen_work, expected.platen_work);
  EXPECT_EQ(ledger.elastic, expected.elastic);
  EXPECT_EQ(ledger.tension_failures, expected.tension_failures);
  EXPECT_GT(ledger.tension_failures, 0);
}

TYPED_TEST(LatticeSolver, PlatenMovesAsTheRampSays) {
  mpm::Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  scene.loading.direction = mpm::Direction::compression;
  const mpm::Plan plan = mpm::plan(scene);
  mpm::LatticeSolver<TypeParam> solver(scene, plan);
  const std::int64_t steps = 400;
  double expected = 0;
  for (std::int64_t i = 0; i + 1 < steps; ++i)
    expected += plan.dt * scene.loading.velocity * mpm::ramp(plan, (static_cast<double>(i) + 0.5) * plan.dt);
  EXPECT_NEAR(solver.advance(steps).platen_displacement, expected, 1e-12 * expected);
}

TYPED_TEST(LatticeSolver, ForcesOfBothPlatensBalanceTheMomentum) {
  mpm::Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  scene.local_damping = 0.5;
  const mpm::Plan plan = mpm::plan(scene);
  mpm::LatticeSolver<TypeParam> solver(scene, plan);
  const mpm::Ledger ledger = solver.advance(4000);
  EXPECT_GT(ledger.force_top, 0) << "the platen pulls upwards";
  EXPECT_NEAR(ledger.force_bottom, -ledger.force_top, 0.02 * ledger.force_top);
}

// Nothing stops an unstable run here, so that its numbers overflow.
TYPED_TEST(LatticeSolver, TellsTheStepAtWhichAReactionIsNoNumber) {
  mpm::Scene scene = samples::unbreakable(samples::small_concrete(20, 20));
  scene.loading.stop_strain = 0.01;  // beyond the steps taken here
  mpm::Plan plan = mpm::plan(scene);
  plan.dt *= 4;
  mpm::LatticeSolver<TypeParam> solver(scene, plan);
  EXPECT_EQ(solver.advance(10).diverged_at, -1);
  const std::int64_t step = solver.advance(20000).diverged_at;
  EXPECT_GT(step, 10);
  EXPECT_EQ(solver.advance(10).diverged_at, step) << "the first such step stays";
}

}  // namespace lattice_solver_test
