// What only a solver alone shows; whole runs are in checkpoint_test.cpp.
#include <gtest/gtest.h>

#include "libmpm/solver/archive.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace moving_archive_test {

using mpm::Scene;
using samples::Moving;

std::string state_of(const Moving<double>& it) {
  mpm::ArchiveWriter archive;
  it.solver.save(archive);
  return archive.take();
}

/// Whether a solver that takes over the state of another goes the same way.
void expect_same_way(Moving<double>& it, int steps) {
  Moving<double> other(it.scene);
  mpm::MovingStart no_points;
  no_points.maps = mpm::empty_maps(other.scene, other.plan);
  mpm::MovingSolver<double> solver(other.scene, other.plan, std::move(no_points));
  const std::string state = state_of(it);
  mpm::ArchiveReader archive(state);
  solver.restore(archive);
  archive.finish();
  ASSERT_TRUE(archive.ok()) << archive.fault();
  const mpm::Ledger wanted = it.solver.advance(steps);
  const mpm::Ledger found = solver.advance(steps);
  EXPECT_EQ(wanted.trouble, "");
  EXPECT_EQ(found.time, wanted.time);
  EXPECT_EQ(found.force_bottom, wanted.force_bottom);
  mpm::ArchiveWriter end;
  solver.save(end);
  EXPECT_TRUE(end.take() == state_of(it));
}

// What was fast and is slow now lets the step grow, by a twentieth a step.
TEST(MovingArchive, KeepsTheStepThatMayGrow) {
  Moving<double> it(samples::soft_body(12, 12, 0.05));
  it.solver.kick([](const mpm::PointView&, double& vx, double& /*vy*/) { vx = 60; });
  (void)it.solver.advance(1);
  it.solver.kick([](const mpm::PointView&, double& vx, double& /*vy*/) { vx = 1; });
  const double first = it.solver.dt();
  (void)it.solver.advance(2);
  ASSERT_NEAR(it.solver.dt() / first, 1.05 * 1.05, 0.06) << "it grows as fast as it may";
  expect_same_way(it, 3);
}

// The node that smooth platens hold stays the one that it was at first, also when the specimen slides off it.
TEST(MovingArchive, KeepsTheNodeThatIsHeld) {
  Scene scene = samples::soft_body(8, 24, 0.05);
  scene.labels.leftCols(8).setZero();
  scene.labels.rightCols(8).setZero();
  scene.loading.direction = mpm::Direction::compression;
  scene.loading.velocity = 0.1;
  scene.loading.stop_strain = 0.5;
  scene.loading.duration = 0;
  scene.motion.margin = 0.5;
  Moving<double> it(scene);
  for (int i = 0; i < 50; ++i) {
    it.solver.kick([](const mpm::PointView&, double& vx, double& /*vy*/) { vx = 40; });
    ASSERT_EQ(it.solver.advance(1).trouble, "");
  }
  double leftmost = 10;
  for (const mpm::PointView& point : it.solver.points()) leftmost = std::min(leftmost, point.x);
  ASSERT_GT(leftmost, 12 * 0.05 + 2 * it.plan.cell_size) << "it has left the middle";
  expect_same_way(it, 5);
}

}  // namespace moving_archive_test
