#include "libmpm/solver/quasi_static/separate_points.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "libmpm/material/failure.hpp"
#include "libmpm/solver/force_buffer.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace separate_points_test {

using mpm::SeparatePoints;

Eigen::Vector3d some_strain(int i) {
  return {std::sin(1.0 + 7 * i), std::cos(3.0 * i), 1.5 * std::sin(0.3 + 11 * i)};
}

// The law of explicit runs: the stiffness times the strain is the stress that they have.
TEST(CrackedStiffness, GivesTheStressOfTheLaw) {
  for (const mpm::Plane plane : {mpm::Plane::strain, mpm::Plane::stress})
    for (const double cracked : {0.3, 1.0}) {
      const mpm::Phase phase = mpm::concrete_phases()[1];
      const Eigen::Matrix3d c = mpm::stiffness(phase, plane);
      const mpm::DamageLaw law{.plane = plane, .closure = mpm::CrackClosure::unilateral};
      int closed = 0;
      int open = 0;
      for (int i = 0; i < 400; ++i) {
        const Eigen::Vector3d s = c * some_strain(i);
        const mpm::Stress<double> expected =
            carried_stress({.phase = &phase, .kept = 1, .cracked = cracked}, {s[0], s[1], s[2]}, law);
        const Eigen::Vector3d found = mpm::cracked_stiffness(c, cracked, some_strain(i)) * some_strain(i);
        const double tolerance = 3e-6 * s.norm();
        EXPECT_NEAR(found[0], expected.xx, tolerance) << i;
        EXPECT_NEAR(found[1], expected.yy, tolerance) << i;
        EXPECT_NEAR(found[2], expected.xy, tolerance) << i;
        closed += (found - s).norm() < tolerance ? 1 : 0;
        open += found.norm() < (1.001 - cracked) * s.norm() ? 1 : 0;
      }
      EXPECT_GT(closed, 20);
      EXPECT_GT(open, 20);
    }
}

// So that a step with it is one of Newton's method, and its energy is convex.
TEST(CrackedStiffness, IsTheDerivativeOfTheStressAndPositive) {
  const Eigen::Matrix3d c = mpm::stiffness(mpm::concrete_phases()[1], mpm::Plane::strain);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d k = mpm::cracked_stiffness(c, 1, some_strain(i));
    EXPECT_LT((k - k.transpose()).norm(), 1e-12 * c.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> values(k);
    EXPECT_GT(values.eigenvalues()[0], 0);
    const double step = 1e-6;
    for (int j = 0; j < 3; ++j) {
      const auto stress_at = [&](double by) -> Eigen::Vector3d {
        const Eigen::Vector3d strain = some_strain(i) + by * Eigen::Vector3d::Unit(j);
        return mpm::cracked_stiffness(c, 1, strain) * strain;
      };
      const Eigen::Vector3d slope = (stress_at(step) - stress_at(-step)) / (2 * step);
      EXPECT_LT((slope - k.col(j)).norm(), 1e-5 * c.norm()) << i << " " << j;
    }
  }
}

/// Two points in the cell (0, 1) of a row of two.
SeparatePoints two_points(double cracked) {
  const Eigen::Matrix3d c = mpm::stiffness(mpm::concrete_phases()[1], mpm::Plane::strain);
  SeparatePoints points(1, 8);
  points.put({{0, 0, 1}, 1, 0.5, 0.5}, {0.5 * c, true}, {1, cracked});
  points.put({{0, 5, 1}, 5, 0.2, 0.9}, {0.5 * c, false}, {0.7, 0});
  return points;
}

const double nodes_x[4][3] = {{0, 0.1, -0.3}, {0, -0.2, 0.4}, {0, 0.3, 0.15}, {0, -0.4, 0.25}};

mpm::CellDisplacement moved(int cell) {
  const auto& [lower_x, lower_y, upper_x, upper_y] = nodes_x;
  return {{lower_x[cell], lower_x[cell + 1], upper_x[cell], upper_x[cell + 1]},
          {lower_y[cell], lower_y[cell + 1], upper_y[cell], upper_y[cell + 1]}};
}

// What the sweeps do and what the coarser grids are made of are the same.
TEST(SeparatePoints, HaveForcesThatAreThoseOfTheirMatrix) {
  SeparatePoints points = two_points(0.6);
  points.follow(0, SeparatePoints::most_caution, moved);
  ASSERT_EQ(points.changed().size(), 2U);
  EXPECT_TRUE(points.changed().empty());
  mpm::ForceBuffer<double> lower, upper;
  for (auto* buffer : {&lower, &upper}) buffer->resize(16);
  mpm::kernels::CellRow<double, double> row{};
  row.ux_lower = nodes_x[0];
  row.uy_lower = nodes_x[1];
  row.ux_upper = nodes_x[2];
  row.uy_upper = nodes_x[3];
  row.lower = lower.forces();
  row.upper = upper.forces();
  points.add_forces(0, row);
  const mpm::CellDisplacement u = moved(1);
  Eigen::Matrix<double, 8, 1> all;
  all << u.ux[0], u.ux[1], u.ux[2], u.ux[3], u.uy[0], u.uy[1], u.uy[2], u.uy[3];
  const Eigen::Matrix<double, 8, 1> expected = -(mpm::by_nodes(points.in_cell(0, 1), 1) * all);
  const double found[8] = {row.lower.left_x[1],  row.lower.right_x[1], row.upper.left_x[1],
                           row.upper.right_x[1], row.lower.left_y[1],  row.lower.right_y[1],
                           row.upper.left_y[1],  row.upper.right_y[1]};
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12 * expected.norm()) << i;
  EXPECT_EQ(row.lower.left_x[0], 0);
  EXPECT_EQ(points.in_cell(0, 0).norm(), 0);
}

TEST(SeparatePoints, TellOfWhatAPreconditionerDoesNotBear) {
  SeparatePoints points = two_points(1);
  const auto turned = [](double angle) {
    return [angle](int) {
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      // Opened by 1 along a direction, pressed by 0.5 across it.
      const double xx = c * c - 0.5 * s * s, yy = s * s - 0.5 * c * c, xy = 1.5 * s * c;
      return mpm::CellDisplacement{{0, xx, xy, xx + xy}, {0, xy, yy, xy + yy}};
    };
  };
  points.follow(0, SeparatePoints::most_caution, turned(0.3));
  EXPECT_EQ(points.changed().size(), 2U);
  points.follow(0, SeparatePoints::most_caution, turned(0.31));
  EXPECT_TRUE(points.changed().empty());
  points.follow(0, SeparatePoints::most_caution,
                turned(0.45));  // what was open is twice as stiff, though little on the whole
  EXPECT_EQ(points.changed().size(), 1U);
}

TEST(SeparatePoints, ComeAndGo) {
  SeparatePoints points = two_points(1);
  EXPECT_TRUE(points.any_cracked());
  points.put({{0, 0, 1}, 1, 0.5, 0.5}, {}, {1, 0});
  EXPECT_FALSE(points.any_cracked());
  EXPECT_FALSE(points.state(2).has_value());
  points.remove(0, 1);
  points.remove(0, 1);
  points.remove(0, 5);
  EXPECT_TRUE(points.empty());
}

}  // namespace separate_points_test
