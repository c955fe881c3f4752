#include "libmpm/kernels/moving_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/libmpm/kernel_stage.hpp"

namespace moving_kernels_test {

using samples::Method;
using samples::Stage;

template <class Real>
class MovingKernels : public testing::Test {
 protected:
  /// Rounding of a sum of a few hundred terms of size one.
  static constexpr double rounding = 300 * static_cast<double>(std::numeric_limits<Real>::epsilon());
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingKernels, Precisions);

/// Places that matter: random ones, and those at and beside the edges of cells, tiles and points.
template <class Visit>
void for_places(Visit&& visit) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < 200; ++i) {
    const double x = uniform() * 0.7;
    visit(x, uniform() * 0.5);
  }
  for (const double offset : {0.0, 0.025, 0.05, 0.075})
    for (const double beside : {-1e-9, 0.0, 1e-9}) visit(0.3 + offset + beside, 0.2 - offset - beside);
}

// Of each shape: weights sum to 1, gradients to 0 (partition of unity); weighted places of the nodes give the
// place of the point, weighted gradients the unit matrix (linear completeness); weights are never negative.
TYPED_TEST(MovingKernels, WeightsAreAPartitionOfUnityAndLinearlyComplete) {
  for (const auto shape : samples::all_shapes()) {
    for_places([&](double x, double y) {
      Stage<TypeParam> stage({shape});
      auto point = stage.point_at(x, y);
      point.values[mpm::moving::sxx] = point.values[mpm::moving::syy] = 1;
      stage.points.insert(point);
      stage.scatter();
      double w = 0, wx = 0, wy = 0, g[2] = {0, 0}, gx[2] = {0, 0}, gy[2] = {0, 0};
      stage.for_each_node([&](int row, int col) {
        const double weight = stage.node_sum(stage.momentum, 3, 0, row, col);
        EXPECT_GE(weight, -1e-7);
        EXPECT_EQ(static_cast<TypeParam>(weight), stage.grid.mass[stage.grid.at(row, col)]);
        w += weight;
        wx += weight * stage.node_x(col);
        wy += weight * stage.node_y(row);
        for (int k = 0; k < 2; ++k) {
          const double gradient = -stage.node_sum(stage.force, 2, k, row, col);
          g[k] += gradient;
          gx[k] += gradient * stage.node_x(col);
          gy[k] += gradient * stage.node_y(row);
        }
      });
      EXPECT_NEAR(w, 1, this->rounding);
      EXPECT_NEAR(wx, x, this->rounding);
      EXPECT_NEAR(wy, y, this->rounding);
      for (int k = 0; k < 2; ++k) {
        EXPECT_NEAR(g[k], 0, 10 * this->rounding);
        EXPECT_NEAR(gx[k], k == 0 ? 1 : 0, this->rounding);
        EXPECT_NEAR(gy[k], k == 1 ? 1 : 0, this->rounding);
      }
    });
  }
}

/// Weight of a point of width 2 l (over the cell) on a node at distance d cells, and its derivative: the tent
/// averaged over the point. Source: Bardenhagen, Kober (2004), eq. 38, written out.
double averaged_tent(double d, double l) {
  const double a = std::abs(d);
  if (a < l) return 1 - (d * d + l * l) / (2 * l);
  if (a <= 1 - l) return 1 - a;
  if (a < 1 + l) return (1 + l - a) * (1 + l - a) / (4 * l);
  return 0;
}

TYPED_TEST(MovingKernels, WeightsAreThoseOfTheLiterature) {
  for (const auto shape : samples::all_shapes()) {
    for_places([&](double x, double y) {
      Stage<TypeParam> stage({shape});
      stage.points.insert(stage.point_at(x, y));
      stage.scatter();
      const double l = shape == mpm::Shape::linear ? 1e-9 : shape == mpm::Shape::gimp ? 0.25 : 0.5;
      stage.for_each_node([&](int row, int col) {
        const double expected = averaged_tent(x / 0.1 - (col - stage.geometry.before), l) *
                                averaged_tent(y / 0.1 - (row - stage.geometry.before), l);
        EXPECT_NEAR(stage.node_sum(stage.momentum, 3, 0, row, col), expected, 1e-8 + this->rounding);
      });
    });
  }
}

// Mass and momentum of the nodes are those of the points, with APIC too: the affine parts cancel because the
// weights are linearly complete. Internal forces sum to nothing.
TYPED_TEST(MovingKernels, ScatterKeepsMassAndMomentum) {
  for (const Method& method : samples::all_methods()) {
    if (method.scheme != mpm::Scheme::usf) continue;
    Stage<TypeParam> stage(method);
    stage.scatter_anywhere(150);
    stage.scatter();
    double expected[3] = {0, 0, 0}, sums[3] = {0, 0, 0}, forces[2] = {0, 0};
    stage.for_each_point([&](const auto& slot) {
      const double m = stage.value(slot, mpm::moving::mass);
      expected[0] += m;
      expected[1] += m * stage.value(slot, mpm::moving::vx);
      expected[2] += m * stage.value(slot, mpm::moving::vy);
    });
    stage.for_each_node([&](int row, int col) {
      for (int k = 0; k < 3; ++k) sums[k] += stage.node_sum(stage.momentum, 3, k, row, col);
      for (int k = 0; k < 2; ++k) forces[k] += stage.node_sum(stage.force, 2, k, row, col);
    });
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sums[k], expected[k], 100 * this->rounding) << method.name();
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(forces[k], 0, 1000 * this->rounding) << method.name();
  }
}

// A linear field of velocity at the nodes comes to the points as it is: value, gradient of APIC, strain.
TYPED_TEST(MovingKernels, GatherIsExactForLinearFields) {
  const double l[4] = {0.3, -0.7, 0.2, 0.5};
  for (const Method& method : samples::all_methods(0.5)) {
    if (method.scheme != mpm::Scheme::usf) continue;
    for (const bool folds : {false, true}) {
      Stage<TypeParam> stage(method);
      stage.folds = folds;
      stage.scatter_anywhere(100);
      std::map<std::uint32_t, std::array<double, 2>> before;
      stage.for_each_node([&](int row, int col) {
        const std::size_t at = stage.grid.at(row, col);
        const double x = stage.node_x(col);
        const double y = stage.node_y(row);
        stage.grid.fresh_x[at] = static_cast<TypeParam>(1 + l[0] * x + l[1] * y);
        stage.grid.fresh_y[at] = static_cast<TypeParam>(2 + l[2] * x + l[3] * y);
        stage.grid.change_x[at] = static_cast<TypeParam>(0.5 - x);
        stage.grid.change_y[at] = static_cast<TypeParam>(0.25 + y);
      });
      stage.for_each_point([&](const auto& slot) {
        before[stage.points.id(slot)] = {stage.value(slot, mpm::moving::vx),
                                         stage.value(slot, mpm::moving::vy)};
      });
      double fastest = 0;
      for (int row = 0; row < stage.points.rows(); ++row)
        fastest = std::max(
            fastest, static_cast<double>(stage.sweeps.gather(stage.tiles(row), stage.step, stage.change(row),
                                                             stage.fresh(row), stage.force.sums(row))));
      double expected_fastest = 0;
      stage.for_each_point([&](const auto& slot) {
        const double x = stage.point_x(slot);
        const double y = stage.point_y(slot);
        const auto old = before[stage.points.id(slot)];
        const double pic[2] = {1 + l[0] * x + l[1] * y, 2 + l[2] * x + l[3] * y};
        const double flip[2] = {old[0] + 0.5 - x, old[1] + 0.25 + y};
        const double r = method.transfer == mpm::Transfer::apic ? 0 : method.flip_ratio;
        const double vx = stage.value(slot, mpm::moving::vx);
        const double vy = stage.value(slot, mpm::moving::vy);
        EXPECT_NEAR(vx, r * flip[0] + (1 - r) * pic[0], this->rounding) << method.name();
        EXPECT_NEAR(vy, r * flip[1] + (1 - r) * pic[1], this->rounding) << method.name();
        expected_fastest = std::max(expected_fastest, vx * vx + vy * vy);
        const int a = stage.points.layout().affine;
        for (int k = 0; a >= 0 && k < 4; ++k)
          EXPECT_NEAR(stage.value(slot, a + k), l[k], 20 * this->rounding);
      });
      EXPECT_NEAR(fastest, expected_fastest, 10 * this->rounding);
    }
  }
}

// Every instruction set gives the same to rounding. Blocks have other widths there, so points are compared by
// their number.
TYPED_TEST(MovingKernels, InstructionSetsAgreeToRounding) {
  for (const Method& method : samples::all_methods()) {
    if (method.scheme != mpm::Scheme::usf) continue;
    std::map<std::uint32_t, std::array<double, 12>> reference;
    for (const auto* kernels : mpm::available_kernels()) {
      Stage<TypeParam> stage(method, kernels->name);
      stage.scatter_anywhere(150);
      stage.scatter();
      stage.for_each_node([&](int row, int col) {
        const std::size_t at = stage.grid.at(row, col);
        stage.grid.change_x[at] = static_cast<TypeParam>(stage.node_sum(stage.force, 2, 0, row, col) * 1e-3);
        stage.grid.change_y[at] = static_cast<TypeParam>(stage.node_sum(stage.force, 2, 1, row, col) * 1e-3);
        stage.grid.fresh_x[at] = stage.grid.vx[at] + stage.grid.change_x[at];
        stage.grid.fresh_y[at] = stage.grid.vy[at] + stage.grid.change_y[at];
      });
      std::vector<std::uint8_t> flags(static_cast<std::size_t>(stage.points.blocks()));
      for (int row = 0; row < stage.points.rows(); ++row) {
        (void)stage.sweeps.gather(stage.tiles(row), stage.step, stage.change(row), stage.fresh(row),
                                  stage.force.sums(row));
        (void)stage.sweeps.strain(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row),
                                  flags.data());
        stage.sweeps.deform(stage.tiles(row), stage.step, stage.fresh(row));
        (void)stage.sweeps.move(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row),
                                flags.data());
      }
      int points = 0;
      stage.for_each_point([&](const auto& slot) {
        ++points;
        const auto value = [&](int f) { return static_cast<double>(stage.value(slot, f)); };
        const int f = stage.points.layout().deformation;
        const std::array<double, 12> now{value(mpm::moving::xi),
                                         value(mpm::moving::eta),
                                         value(mpm::moving::vx),
                                         value(mpm::moving::vy),
                                         value(mpm::moving::sxx),
                                         value(mpm::moving::syy),
                                         value(mpm::moving::sxy),
                                         value(mpm::moving::volume),
                                         value(f),
                                         value(f + 1),
                                         value(f + 2),
                                         value(f + 3)};
        const auto [at, first] = reference.try_emplace(stage.points.id(slot), now);
        if (first) return;
        for (std::size_t k = 0; k < now.size(); ++k)
          EXPECT_NEAR(now[k], at->second[k], 10 * this->rounding) << kernels->name << ' ' << method.name();
      });
      EXPECT_EQ(points, 150);
    }
  }
}

// Nodes that go to where a turn takes them turn the stress with the material and change nothing else: its
// invariants and the volume stay, whatever the angle of a step.
TYPED_TEST(MovingKernels, ATurnKeepsTheInvariantsOfTheStress) {
  for (const auto shape : samples::all_shapes()) {
    Stage<TypeParam> stage({shape});
    const double turn = 0.01;  // in a step
    const int steps = 157;     // a quarter of a turn
    auto point = stage.point_at(0.313, 0.177);
    point.values[mpm::moving::sxx] = 1;
    point.values[mpm::moving::syy] = TypeParam(-0.5);
    point.values[mpm::moving::sxy] = TypeParam(0.25);
    stage.points.insert(point);
    stage.step.dt = 1;
    stage.for_each_node([&](int row, int col) {
      const double x = stage.node_x(col);
      const double y = stage.node_y(row);
      const double back = std::cos(turn) - 1;
      stage.grid.fresh_x[stage.grid.at(row, col)] = static_cast<TypeParam>(back * x - std::sin(turn) * y);
      stage.grid.fresh_y[stage.grid.at(row, col)] = static_cast<TypeParam>(std::sin(turn) * x + back * y);
    });
    std::vector<std::uint8_t> flags(static_cast<std::size_t>(stage.points.blocks()));
    for (int i = 0; i < steps; ++i)
      for (int row = 0; row < stage.points.rows(); ++row)
        (void)stage.sweeps.strain(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row),
                                  flags.data());
    stage.for_each_point([&](const auto& slot) {
      const double xx = stage.value(slot, mpm::moving::sxx);
      const double yy = stage.value(slot, mpm::moving::syy);
      const double xy = stage.value(slot, mpm::moving::sxy);
      const double tolerance = 3 * this->rounding;
      EXPECT_NEAR(xx + yy, 0.5, tolerance);
      EXPECT_NEAR(std::hypot(0.5 * (xx - yy), xy), std::hypot(0.75, 0.25), tolerance);
      const double angle = 2 * steps * turn;
      EXPECT_NEAR(0.5 * (xx - yy), 0.75 * std::cos(angle) - 0.25 * std::sin(angle), tolerance);
      EXPECT_NEAR(xy, 0.75 * std::sin(angle) + 0.25 * std::cos(angle), tolerance);
      EXPECT_NEAR(stage.value(slot, mpm::moving::volume), 1, tolerance);
    });
  }
}

// Nodes that fly straight on while they turn move apart; that is a strain of half the square of the spin, and
// what keeps a body that turns together.
TYPED_TEST(MovingKernels, FlyingStraightOnInATurnStretches) {
  Stage<TypeParam> stage({mpm::Shape::gimp});
  const double spin = 0.1;  // in a step
  stage.points.insert(stage.point_at(0.313, 0.177));
  stage.step.dt = 1;
  stage.for_each_node([&](int row, int col) {
    stage.grid.fresh_x[stage.grid.at(row, col)] = static_cast<TypeParam>(-spin * stage.node_y(row));
    stage.grid.fresh_y[stage.grid.at(row, col)] = static_cast<TypeParam>(spin * stage.node_x(col));
  });
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(stage.points.blocks()));
  for (int row = 0; row < stage.points.rows(); ++row)
    (void)stage.sweeps.strain(stage.tiles(row), stage.step, stage.fresh(row), stage.fresh(row), flags.data());
  stage.for_each_point([&](const auto& slot) {
    const double stretch = 0.5 * spin * spin / (1 + 0.25 * spin * spin);
    const double lame = stage.value(slot, mpm::moving::lame);
    const double shear = stage.value(slot, mpm::moving::shear);
    ASSERT_GT(shear, 0);
    EXPECT_NEAR(stage.value(slot, mpm::moving::sxx), 2 * (lame + shear) * stretch, 30 * this->rounding);
    EXPECT_NEAR(stage.value(slot, mpm::moving::syy), 2 * (lame + shear) * stretch, 30 * this->rounding);
    EXPECT_NEAR(stage.value(slot, mpm::moving::sxy), 0, 30 * this->rounding);
  });
}

// At a support the quadratic shapes have no weight beyond it, stay complete, and give a point at the support
// the motion of its node alone.
TYPED_TEST(MovingKernels, FoldedWeightsEndAtTheSupportAndStayComplete) {
  for (const auto shape : {mpm::Shape::gimp, mpm::Shape::bspline}) {
    for (const double x : {0.0, 0.01, 0.024, 0.03, 0.0499, 0.35, 0.66, 0.69, 0.7}) {
      for (const double y : {0.0, 0.02, 0.25, 0.47, 0.5}) {
        Stage<TypeParam> stage({shape});
        auto point = stage.point_at(x, y);
        point.values[mpm::moving::sxx] = point.values[mpm::moving::syy] = 1;
        stage.points.insert(point);
        stage.folds = true;
        stage.scatter();
        double w = 0, wx = 0, wy = 0, gx = 0, gy = 0;
        stage.for_each_node([&](int row, int col) {
          const double weight = stage.node_sum(stage.momentum, 3, 0, row, col);
          const bool beyond =
              row == 0 || col == 0 || row == stage.geometry.nodes_y - 1 || col == stage.geometry.nodes_x - 1;
          EXPECT_TRUE(!beyond || weight == 0);
          EXPECT_GE(weight, -this->rounding);
          w += weight;
          wx += weight * stage.node_x(col);
          wy += weight * stage.node_y(row);
          gx -= stage.node_sum(stage.force, 2, 0, row, col) * stage.node_x(col);
          gy -= stage.node_sum(stage.force, 2, 1, row, col) * stage.node_y(row);
          EXPECT_TRUE(x > 0 || col <= 1 || std::abs(weight) < this->rounding);
        });
        EXPECT_NEAR(w, 1, this->rounding);
        EXPECT_NEAR(wx, x, this->rounding);
        EXPECT_NEAR(wy, y, this->rounding);
        EXPECT_NEAR(gx, 1, this->rounding);
        EXPECT_NEAR(gy, 1, this->rounding);
      }
    }
  }
}

}  // namespace moving_kernels_test
