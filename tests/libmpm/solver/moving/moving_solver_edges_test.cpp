// The edges of the grid: closed and open ones, walls and planes of symmetry.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace moving_solver_edges_test {

using mpm::Scene;
using samples::Method;
using samples::Moving;

/// A block of 4 x 4 cells in the middle of 10 x 10, thrown.
Scene thrown_block(double vx, double vy) {
  Scene scene = samples::soft_body(20, 20, 0.05);
  scene.labels.setConstant(0);
  scene.labels.block(6, 6, 8, 8).setConstant(samples::soft);
  scene.loading.initial_velocity_x = vx;
  scene.loading.initial_velocity_y = vy;
  scene.motion.margin = 0.1;
  return scene;
}

TEST(Edges, AClosedOneIsAnErrorWithThePointAndTheStep) {
  for (const bool across : {true, false}) {
    Scene scene = thrown_block(across ? 5 : 0, across ? 0 : -5);
    scene.loading.duration = 0.4;
    try {
      (void)mpm::simulate(scene);
      FAIL() << "a point that leaves must not go unseen";
    } catch (const mpm::Diverged& diverged) {
      EXPECT_THAT(diverged.what(),
                  testing::HasSubstr(across ? "left the grid at the right edge, the point of pixel (row "
                                            : "left the grid at the bottom edge, the point of pixel (row "));
      EXPECT_THAT(diverged.what(),
                  testing::HasSubstr(across ? "motion.right = \"open\"" : "motion.bottom = \"open\""));
      EXPECT_THAT(diverged.what(), testing::HasSubstr("at step "));
      EXPECT_FALSE(diverged.result.history.empty());
    }
  }
}

TEST(Edges, AnOpenOneTakesPointsOutAndCountsThemWithTheirEnergy) {
  for (const auto shape : samples::all_shapes()) {
    Scene scene = thrown_block(5, 0);
    scene.motion.shape = shape;
    scene.motion.right = mpm::Edge::open;
    scene.loading.duration = 0.2;
    const mpm::Result result = mpm::simulate(scene);
    const mpm::HistoryRow& last = result.history.back();
    EXPECT_EQ(last.left_points, 64);
    EXPECT_EQ(last.moving_points, 0);
    EXPECT_NEAR(last.left, result.history.front().kinetic, 1e-9 * last.left);
    EXPECT_LT(result.energy_error, 1e-9);
    EXPECT_TRUE(result.end_x.isNaN().all());
  }
}

// A block thrown at a wall comes back with its momentum turned round, and with no more energy than it had;
// APIC spends some in the contact.
TEST(Edges, ABlockReboundsFromAWall) {
  for (const Method& method : samples::all_methods(0.99)) {
    for (const mpm::Edge wall : {mpm::Edge::smooth_wall, mpm::Edge::rough_wall}) {
      for (int side = 0; side < 4; ++side) {
        const double v[2] = {side == 0   ? -2.0
                             : side == 1 ? 2.0
                                         : 0.0,
                             side == 2   ? -2.0
                             : side == 3 ? 2.0
                                         : 0.0};
        Scene scene = thrown_block(v[0], v[1]);
        scene.motion.left = scene.motion.right = scene.motion.bottom = scene.motion.top = wall;
        method.give_to(scene);
        Moving<double> it(scene);
        const samples::Sums before = samples::sums_of(it.solver);
        mpm::Ledger ledger;
        while (it.solver.time() < 0.25 && ledger.trouble.empty()) ledger = it.solver.advance(20);
        EXPECT_EQ(ledger.trouble, "") << method.name();
        const samples::Sums after = samples::sums_of(it.solver);
        const double along =
            (after.px * before.px + after.py * before.py) / std::pow(std::hypot(before.px, before.py), 2);
        const double across =
            (after.px * before.py - after.py * before.px) / std::pow(std::hypot(before.px, before.py), 2);
        if (samples::figures && side == 0 && wall == mpm::Edge::smooth_wall)
          std::printf("%-22s rebound %.4f\n", method.name().c_str(), -along);
        EXPECT_NEAR(across, 0, 1e-9) << method.name();
        EXPECT_LT(along, method.transfer == mpm::Transfer::apic ? -0.75 : -0.96) << method.name();
        EXPECT_GT(along, -1.03) << method.name();
      }
    }
  }
}

// Along a smooth wall a block slides freely, on a rough one it does not.
TEST(Edges, SmoothWallsLetSlide) {
  for (const auto shape : samples::all_shapes()) {
    for (const mpm::Edge wall : {mpm::Edge::smooth_wall, mpm::Edge::rough_wall, mpm::Edge::symmetry}) {
      Scene scene = thrown_block(-1, -0.5);
      scene.labels.setConstant(0);
      scene.labels.block(12, 6, 8, 8).setConstant(samples::soft);
      scene.motion.shape = shape;
      scene.motion.bottom = wall;
      Moving<double> it(scene);
      const samples::Sums before = samples::sums_of(it.solver);
      EXPECT_EQ(it.solver.advance(40).trouble, "");
      const samples::Sums after = samples::sums_of(it.solver);
      if (wall == mpm::Edge::rough_wall)
        EXPECT_GT(after.px, 0.9 * before.px);
      else
        EXPECT_NEAR(after.px, before.px, 1e-12 * std::abs(before.px));
    }
  }
}

// Half a specimen with a plane of symmetry moves as the whole one does: to rounding with linear shapes, as
// long as no point reaches over the plane with GIMP. With B-splines points see a straight line across the
// plane and not the parabola of the whole, which is of second order in the cell; there are four.
TEST(Edges, APlaneOfSymmetryStandsForTheOtherHalf) {
  for (const auto shape : samples::all_shapes()) {
    Scene whole = samples::soft_body(8, 16, 0.05, 0.3);
    whole.motion.margin = 0.2;
    whole.motion.shape = shape;
    Scene half = whole;
    half.labels = half.labels.leftCols(8).eval();
    half.motion.right = mpm::Edge::symmetry;
    Moving<double> a(whole);
    Moving<double> b(half);
    const auto kick = [](const mpm::PointView& p, double& vx, double& vy) {
      vx = 0.5 * std::cos(1.25 * 3.14159265358979 * p.x);
      vy = 0.5 * std::sin(7 * p.y) * std::sin(1.25 * 3.14159265358979 * p.x);
    };
    a.solver.kick(kick);
    b.solver.kick(kick);
    double error = 0, size = 0;
    (void)a.solver.advance(40);
    (void)b.solver.advance(40);
    for (const auto& p : a.solver.points())
      for (const auto& q : b.solver.points())
        if (p.id % 16 < 8 && p.id / 16 == q.id / 8 && p.id % 16 == q.id % 8) {
          error = std::max({error, std::abs(p.stress.xx - q.stress.xx), std::abs(p.stress.yy - q.stress.yy)});
          size = std::max({size, std::abs(p.stress.xx), std::abs(p.stress.yy)});
        }
    if (samples::figures)
      std::printf("symmetry, shape %d: stress differs by %.2e of its largest\n", static_cast<int>(shape),
                  error / size);
    const double tolerance = shape == mpm::Shape::linear ? 1e-12 : shape == mpm::Shape::gimp ? 1e-3 : 0.1;
    EXPECT_LT(error, tolerance * size);
  }
}

TEST(Edges, KeepAPointThatStandsOnAPlaneOfSymmetry) {
  for (const auto shape : samples::all_shapes()) {
    Scene scene = samples::soft_body(8, 8, 0.05);
    scene.motion.shape = shape;
    scene.motion.left = scene.motion.right = mpm::Edge::symmetry;
    scene.motion.bottom = scene.motion.top = mpm::Edge::symmetry;
    scene.extra_points = {{0, 0.1, samples::soft},
                          {0.4, 0.1, samples::soft},
                          {0.1, 0, samples::soft},
                          {0.1, 0.4, samples::soft},
                          {0.4, 0.4, samples::soft}};
    Moving<double> it(scene);
    it.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
      vx = std::sin(2 * 3.14159265358979 * p.x / 0.4);
      vy = std::sin(2 * 3.14159265358979 * p.y / 0.4);
    });
    EXPECT_EQ(it.solver.advance(500).trouble, "");
    EXPECT_EQ(it.solver.points().size(), 69U);
  }
}

}  // namespace moving_solver_edges_test
