// A disc in free flight: momentum and angular momentum stay, stress turns with the material.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

/// Flight at 3 and 2 m/s times `flight`, with a spin [1/s].
template <class Real>
void throw_it(Moving<Real>& it, double spin, double flight = 1) {
  it.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
    vx = 3 * flight - spin * (p.y - middle);
    vy = 2 * flight + spin * (p.x - middle);
  });
}

/// Variance of the weights along an axis at a place `x` cells from a node [-].
double variance(mpm::Shape shape, double x) {
  const double place = x - std::floor(x);
  const double d = std::min(place, 1 - place);
  if (shape == mpm::Shape::linear) return place * (1 - place);
  const double l = shape == mpm::Shape::bspline ? 0.5 : 0.25;
  return (d < l ? (d * d + l * l) / (2 * l) : d) - d * d;
}

/// Angular momentum about the corner of the picture, with that of the affine part of APIC: its gradient acts
/// on the variance of the weights. Source: Jiang et al. (2015), section 5.3.
double spin_of(const Moving<double>& it) {
  const double h = it.plan.cell_size;
  double sum = 0;
  for (const auto& p : it.solver.points())
    sum +=
        p.mass * (p.x * p.vy - p.y * p.vx + h * h * variance(it.scene.motion.shape, p.x / h) * p.gradient[2] -
                  h * h * variance(it.scene.motion.shape, p.y / h) * p.gradient[1]);
  return sum;
}

// Momentum is kept by every method: weights sum to one both ways, internal forces to nothing. Beside rounding
// only nodes below 1e-12 of a point's mass lose theirs.
TEST(FreeFlight, KeepsMomentumAndMass) {
  for (const Method& method : samples::all_methods(0.99)) {
    mpm::Scene scene = disc(10);
    method.give_to(scene);
    Moving<double> it(scene);
    throw_it(it, 10);
    const Sums before = samples::sums_of(it.solver);
    ASSERT_EQ(it.solver.advance(150).trouble, "") << method.name();
    const Sums after = samples::sums_of(it.solver);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    EXPECT_NEAR(after.px, before.px, 1e-11 * before.px) << method.name();
    EXPECT_NEAR(after.py, before.py, 1e-11 * before.px) << method.name();
  }
}

/// Share of the angular momentum of the spin that a turn of 1.2 rad loses.
double loss(const Method& method, int cells) {
  mpm::Scene scene = disc(cells);
  method.give_to(scene);
  Moving<double> it(scene);
  throw_it(it, 10);
  (void)it.solver.advance(1);
  const Sums first = samples::sums_of(it.solver);
  const double before = spin_of(it);
  while (it.solver.time() < 0.12) (void)it.solver.advance(1);
  const double orbit = middle * first.py - middle * first.px;  // stays, because the momentum does
  const double share = (before - spin_of(it)) / (before - orbit);
  if (samples::figures) std::printf("%-22s %d cells: loses %+.3e\n", method.name().c_str(), cells, share);
  return share;
}

// APIC keeps angular momentum: to rounding with the B-spline, whose gradient is that of the step's own
// velocity and whose weights have one variance everywhere; GIMP changes the variance as the point moves after
// the step, linear shapes take the gradient with light nodes bounded. FLIP loses it because lumped masses
// smooth the velocity with which points move; that falls with the square of the cell. PIC loses it in each
// step.
TEST(FreeFlight, ApicKeepsAngularMomentum) {
  for (const auto scheme : {mpm::Scheme::usf, mpm::Scheme::usl, mpm::Scheme::musl}) {
    EXPECT_LT(std::abs(loss({mpm::Shape::bspline, scheme, mpm::Transfer::apic}, 10)), 1e-11);
    EXPECT_LT(std::abs(loss({mpm::Shape::gimp, scheme, mpm::Transfer::apic}, 10)), 3e-3);
    EXPECT_LT(std::abs(loss({mpm::Shape::linear, scheme, mpm::Transfer::apic}, 10)), 1e-2);
  }
}
TEST(FreeFlight, FlipLosesAngularMomentumWithTheSquareOfTheCell) {
  for (const auto shape : samples::all_shapes()) {
    const double coarse = loss({shape, mpm::Scheme::musl}, 8);
    const double fine = loss({shape, mpm::Scheme::musl}, 16);
    EXPECT_GT(fine, 0);
    EXPECT_LT(coarse, 0.1);
    EXPECT_GT(std::log2(coarse / fine), 1.5);
    EXPECT_GT(loss({shape, mpm::Scheme::musl, mpm::Transfer::flip, 0.99}, 8), coarse);
  }
}

// A disc that spins through a full turn in place: what its points carry stays of the order rho (omega R)^2,
// which the spin asks for. A stress that did not turn with the material would grow without bound.
TEST(FreeFlight, AFullTurnLeavesNoStressBehind) {
  for (const auto shape : samples::all_shapes()) {
    for (const auto transfer : {mpm::Transfer::flip, mpm::Transfer::apic}) {
      mpm::Scene scene = disc(10);
      scene.motion.shape = shape;
      scene.motion.transfer = transfer;
      Moving<double> it(scene);
      throw_it(it, 10, 0);
      const double volume = samples::sums_of(it.solver).volume;
      mpm::Ledger ledger;
      while (it.solver.time() < 0.63 && ledger.trouble.empty()) ledger = it.solver.advance(10);
      ASSERT_EQ(ledger.trouble, "");
      double mean = 0;
      for (const auto& p : it.solver.points())
        mean += p.volume * std::hypot(0.5 * (p.stress.xx - p.stress.yy), p.stress.xy) / volume;
      const double scale = 1000 * 4.5 * 4.5;
      if (samples::figures)
        std::printf("turn, shape %d, transfer %d: shear %.3f of rho (omega R)^2, volume %.5f\n",
                    static_cast<int>(shape), static_cast<int>(transfer), mean / scale,
                    samples::sums_of(it.solver).volume / volume);
      EXPECT_LT(mean, 5 * scale);
      // Points move along tangents: in a step of the angle w the volume grows by w^2, in a turn by 2 pi w.
      const double growth = 2 * std::numbers::pi * 10 * it.solver.dt();
      EXPECT_NEAR(samples::sums_of(it.solver).volume, volume, 1.2 * growth * volume);
    }
  }
}

}  // namespace
