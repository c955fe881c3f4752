// Axial vibration of a bar: period, amplitude and energy of every method.
#include "libmpm/problems/waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/libmpm/moving_scenes.hpp"

namespace bar_vibration_test {

using mpm::problems::vibrate_bar;
using mpm::problems::Vibration;
using samples::figures;
using samples::Method;
using std::numbers::pi;

/// Phase lost in a period [-], from the first to the tenth, so that what the start costs does not count.
double lag(const Vibration& o) { return std::abs(o.ten.lag - o.one.lag) / (9 * 2 * pi); }

// Lumped mass, cells and steps of central differences each err by the square of their size: the period comes
// with second order in every method. FLIP and APIC give most of the energy back after ten periods; a blend
// loses what its share of PIC takes in each step.
void expect_second_order(mpm::Shape shape) {
  for (const Method& method : samples::all_methods(0.99)) {
    if (method.shape != shape) continue;
    SCOPED_TRACE(method.name());
    const Vibration coarse = vibrate_bar(method, 8);
    const Vibration fine = vibrate_bar(method, 16);
    const double order = std::log2(lag(coarse) / lag(fine));
    if (figures)
      std::printf("%-22s lag %.2e %.2e order %.2f amplitude after one %.4f, ten %.4f, energy %.4f\n",
                  method.name().c_str(), lag(coarse), lag(fine), order, fine.one.amplitude,
                  fine.ten.amplitude, fine.energy);
    EXPECT_GT(order, 1.8);
    EXPECT_LT(lag(fine), shape == mpm::Shape::bspline ? 3e-3 : 1.5e-3);
    EXPECT_NEAR(fine.one.amplitude, 1, 5e-3);
    EXPECT_NEAR(fine.ten.amplitude, 1, method.flip_ratio < 1 ? 0.02 : 0.01);
    EXPECT_NEAR(fine.energy, 1, method.flip_ratio < 1 ? 0.04 : 0.02);
  }
}
TEST(BarVibration, LinearShapesAreOfSecondOrder) { expect_second_order(mpm::Shape::linear); }
TEST(BarVibration, GimpIsOfSecondOrder) { expect_second_order(mpm::Shape::gimp); }
TEST(BarVibration, BSplinesAreOfSecondOrder) { expect_second_order(mpm::Shape::bspline); }

// The distance in the plane of displacement and velocity is what remains of both: of second order while the
// period's error makes the most of it, and larger with any damping.
TEST(BarVibration, TheDistanceToTheSolutionHoldsPhaseAndAmplitude) {
  const Method method{mpm::Shape::gimp, mpm::Scheme::musl};
  const Vibration coarse = vibrate_bar(method, 8);
  const Vibration fine = vibrate_bar(method, 16);
  EXPECT_NEAR(coarse.error, 2 * std::sin(0.5 * std::abs(coarse.ten.lag)), 0.1 * coarse.error);
  EXPECT_GT(std::log2(coarse.error / fine.error), 1.7);
  Method pic = method;
  pic.flip_ratio = 0;
  EXPECT_GT(vibrate_bar(pic, 16).error, 0.5) << "PIC damps it away";
  EXPECT_GT(fine.cost.wall_time, 0);
  EXPECT_GT(fine.cost.point_updates, 10 * 64 * 64);
}

}  // namespace bar_vibration_test
