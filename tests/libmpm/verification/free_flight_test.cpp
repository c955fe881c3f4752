// A disc in free flight: momentum and angular momentum stay, stress turns with the material.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libmpm/moving_scenes.hpp"

namespace {

using samples::Method;
using samples::Moving;
using samples::Sums;

constexpr double middle = 0.5;  // of the disc [m]

mpm::Scene disc(int cells) {
  const int pixels = 2 * cells;
  mpm::Scene scene = samples::soft_body(pixels, pixels, 2 * middle / pixels, 0.2);
  samples::keep_disc(scene, 0.5 * pixels, 0.5 * pixels, 0.45 * pixels);
  scene.motion.margin = 0.4;
  return scene;
}

/// Flight at 3, 2 m/s with a spin [1/s].
template <class Real>
void throw_it(Moving<Real>& it, double spin) {
  it.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
    vx = 3 - spin * (p.y - middle);
    vy = 2 + spin * (p.x - middle);
  });
}

/// Variance of the weights along an axis [m^2] where it is one for all points: B-spline. Source: Jiang et al.
/// (2015), D = h^2 / 4 for the quadratic B-spline.
double weights_variance(const Method& method, double h) {
  return method.shape == mpm::Shape::bspline ? 0.25 * h * h : 0;
}

// Momentum is kept to rounding by every method: weights sum to one at both ways, internal forces to nothing.
TEST(FreeFlight, KeepsMomentumAndMass) {
  for (const Method& method : samples::all_methods()) {
    mpm::Scene scene = disc(10);
    method.give_to(scene);
    Moving<double> it(scene);
    throw_it(it, 10);
    const Sums before = samples::sums_of(it.solver);
    ASSERT_EQ(it.solver.advance(150).trouble, "") << method.name();
    const Sums after = samples::sums_of(it.solver);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    EXPECT_NEAR(after.px, before.px, 1e-12 * before.px) << method.name();
    EXPECT_NEAR(after.py, before.py, 1e-12 * before.px) << method.name();
  }
}

TEST(FreeFlight, AngularMomentumFigures) {
  for (const Method& method : samples::all_methods()) {
    mpm::Scene scene = disc(10);
    method.give_to(scene);
    Moving<double> it(scene);
    throw_it(it, 10);
    (void)it.solver.advance(1);
    const double d = weights_variance(method, it.plan.cell_size);
    const Sums before = samples::sums_of(it.solver, d);
    (void)it.solver.advance(300);
    const Sums after = samples::sums_of(it.solver, d);
    const double own = before.spin - (before.py - before.px) * 0;
    std::printf("%-24s L %.6g -> %.6g  (%.3e) kinetic %.4g -> %.4g turn %.3f\n", method.name().c_str(), own, after.spin,
                (after.spin - before.spin) / before.spin, before.kinetic, after.kinetic, 10 * it.solver.time());
  }
}

}  // namespace
