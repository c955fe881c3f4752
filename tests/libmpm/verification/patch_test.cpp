// Constant strain on a moving, irregular set of points: the strain itself, whatever the shape, the number of
// cells crossed and the place of the points. Source: the patch test of Irons for finite elements; the shapes
// are linearly complete, so that nothing but rounding may remain.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/problems/flights.hpp"
#include "tests/libmpm/kernel_stage.hpp"

namespace patch_test {

using samples::Method;
using samples::Stage;

/// Velocity gradient of the patch [1/s], row by row; the turn about the middle keeps the points on the grid.
constexpr double stretch[4] = {0.9, 0.4, 0.2, -0.7};

struct State {
  double x, y, f[4], volume, stress[3];
};

/// Moves a stage of irregular points for `steps` steps with nodes that follow x' = L (x - middle).
template <class Real>
void drive(Stage<Real>& stage, int steps) {
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(stage.points.blocks()));
  stage.for_each_node([&](int row, int col) {
    const std::size_t at = stage.grid.at(row, col);
    const double x = stage.node_x(col) - 0.35;
    const double y = stage.node_y(row) - 0.25;
    stage.grid.fresh_x[at] = static_cast<Real>(stretch[0] * x + stretch[1] * y);
    stage.grid.fresh_y[at] = static_cast<Real>(stretch[2] * x + stretch[3] * y);
  });
  for (int i = 0; i < steps; ++i) {
    std::vector<typename Stage<Real>::Points::Loose> movers;
    for (int row = 0; row < stage.points.rows(); ++row) {
      (void)stage.sweeps.strain(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row),
                                flags.data());
      stage.sweeps.deform(stage.tiles(row), stage.step, stage.fresh(row));
      (void)stage.sweeps.move(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row), flags.data());
      stage.points.for_each(row, [&](const auto& slot) {
        const Real xi = stage.points.value(slot, mpm::moving::xi);
        const Real eta = stage.points.value(slot, mpm::moving::eta);
        if (!(xi >= 0 && xi < 1 && eta >= 0 && eta < 1)) movers.push_back(stage.points.take_out(slot));
      });
    }
    for (auto& mover : movers) {
      for (const bool across : {true, false}) {
        Real& place = mover.values[across ? mpm::moving::xi : mpm::moving::eta];
        (across ? mover.tile.col : mover.tile.row) += static_cast<int>(std::floor(place));
        place -= std::floor(place);
      }
      stage.points.insert(mover);
    }
  }
}

TEST(PatchTest, ConstantStrainRateIsExactOnIrregularPoints) {
  for (const auto shape : samples::all_shapes()) {
    Stage<double> stage({shape});
    stage.step.dt = 1e-3;
    stage.scatter_anywhere(60, 0.8);
    std::map<std::uint32_t, State> before;
    int crossed = 0;
    std::map<std::uint32_t, int> tile;
    stage.for_each_point([&](const auto& slot) {
      const auto value = [&](int f) { return stage.points.value(slot, f); };
      before[stage.points.id(slot)] = {
          stage.point_x(slot),
          stage.point_y(slot),
          {1, 0, 0, 1},
          value(mpm::moving::volume),
          {value(mpm::moving::sxx), value(mpm::moving::syy), value(mpm::moving::sxy)}};
      tile[stage.points.id(slot)] = slot.row * 100 + slot.block * stage.points.lanes() + slot.lane;
    });
    const int steps = 150;
    drive(stage, steps);
    // x and F grow by the same factor A = I + dt L in each step, J by det A, and the stress by what Jaumann's
    // rate makes of M = dt L (I + dt L / 2)^-1, the gradient halfway through the step, with tan(turn / 2) =
    // spin / 2: a 3 x 3 map, applied here step by step.
    const double dt = stage.step.dt;
    const double a[4] = {1 + dt * stretch[0], dt * stretch[1], dt * stretch[2], 1 + dt * stretch[3]};
    double power[4] = {1, 0, 0, 1};
    for (int i = 0; i < steps; ++i) {
      const double p[4] = {power[0], power[1], power[2], power[3]};
      power[0] = a[0] * p[0] + a[1] * p[2];
      power[1] = a[0] * p[1] + a[1] * p[3];
      power[2] = a[2] * p[0] + a[3] * p[2];
      power[3] = a[2] * p[1] + a[3] * p[3];
    }
    const double j = std::pow(a[0] * a[3] - a[1] * a[2], steps);
    const double half[4] = {0.5 * (1 + a[0]), 0.5 * a[1], 0.5 * a[2], 0.5 * (1 + a[3])};
    const double per = dt / (half[0] * half[3] - half[1] * half[2]);
    const double m[4] = {per * (stretch[0] * half[3] - stretch[1] * half[2]),
                         per * (stretch[1] * half[0] - stretch[0] * half[1]),
                         per * (stretch[2] * half[3] - stretch[3] * half[2]),
                         per * (stretch[3] * half[0] - stretch[2] * half[1])};
    const double angle = 4 * std::atan(0.25 * (m[2] - m[1]));
    stage.for_each_point([&](const auto& slot) {
      const auto value = [&](int f) { return stage.points.value(slot, f); };
      const State& old = before.at(stage.points.id(slot));
      crossed +=
          tile[stage.points.id(slot)] != slot.row * 100 + slot.block * stage.points.lanes() + slot.lane;
      const double x = old.x - 0.35;
      const double y = old.y - 0.25;
      EXPECT_NEAR(stage.point_x(slot) - 0.35, power[0] * x + power[1] * y, 1e-13);
      EXPECT_NEAR(stage.point_y(slot) - 0.25, power[2] * x + power[3] * y, 1e-13);
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(value(stage.points.layout().deformation + k), power[k], 1e-12);
      EXPECT_NEAR(value(mpm::moving::volume), j * old.volume, 1e-12);
      double s[3] = {old.stress[0], old.stress[1], old.stress[2]};
      for (int i = 0; i < steps; ++i) {
        const double mean = 0.5 * (s[0] + s[1]);
        const double deviator = 0.5 * (s[0] - s[1]);
        const double turned = deviator * std::cos(angle) - s[2] * std::sin(angle);
        const double volumetric = 2 * (m[0] + m[3]);
        s[2] = deviator * std::sin(angle) + s[2] * std::cos(angle) + 3 * (m[1] + m[2]);
        s[0] = mean + turned + volumetric + 6 * m[0];
        s[1] = mean - turned + volumetric + 6 * m[3];
      }
      EXPECT_NEAR(value(mpm::moving::sxx), s[0], 1e-12);
      EXPECT_NEAR(value(mpm::moving::syy), s[1], 1e-12);
      EXPECT_NEAR(value(mpm::moving::sxy), s[2], 1e-12);
    });
    EXPECT_GT(crossed, 10) << "the points are to cross cells";
  }
}

// In the solver a uniform motion must not strain the irregular points, in any method.
TEST(PatchTest, UniformMotionStrainsNothing) {
  for (const Method& method : samples::all_methods()) {
    SCOPED_TRACE(method.name());
    const auto patch = mpm::problems::fly_uniformly(method);
    ASSERT_EQ(patch.trouble, "");
    EXPECT_LT(patch.strayed, 1e-11);
    EXPECT_LT(patch.stress, 1e-10);
    EXPECT_GT(patch.crossed, 1);
  }
}

}  // namespace patch_test
