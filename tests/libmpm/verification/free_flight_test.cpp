// A disc in free flight: momentum and angular momentum stay, stress turns with the material.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libmpm/problems/flights.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace free_flight_test {

using samples::Method;
using samples::Moving;
using samples::Sums;

// Momentum is kept by every method: weights sum to one both ways, internal forces to nothing. Beside rounding
// only nodes below 1e-12 of a point's mass lose theirs.
TEST(FreeFlight, KeepsMomentumAndMass) {
  for (const Method& method : samples::all_methods(0.99)) {
    mpm::Scene scene = samples::flying_disc(10);
    method.give_to(scene);
    Moving<double> it(scene);
    samples::throw_disc(it, 10);
    const Sums before = samples::sums_of(it.solver);
    ASSERT_EQ(it.solver.advance(150).trouble, "") << method.name();
    const Sums after = samples::sums_of(it.solver);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    EXPECT_NEAR(after.px, before.px, 1e-11 * before.px) << method.name();
    EXPECT_NEAR(after.py, before.py, 1e-11 * before.px) << method.name();
  }
}

double loss(const Method& method, int cells) {
  const auto flight = mpm::problems::fly(method, cells);
  EXPECT_EQ(flight.trouble, "");
  EXPECT_LT(flight.lost_momentum, 1e-11);
  if (samples::figures)
    std::printf("%-22s %d cells: loses %+.3e\n", method.name().c_str(), cells, flight.lost_spin);
  return flight.lost_spin;
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
      mpm::Scene scene = samples::flying_disc(10);
      scene.motion.shape = shape;
      scene.motion.transfer = transfer;
      Moving<double> it(scene);
      samples::throw_disc(it, 10, 0);
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

}  // namespace free_flight_test
