// Axial vibration of a bar, held at the left by a plane of symmetry and free at the right:
// v(x, t) = v0 sin(pi x / 2 L) cos(omega t), omega = pi c / 2 L.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/libmpm/moving_scenes.hpp"

namespace {

using samples::figures;
using samples::Method;
using samples::Moving;
using std::numbers::pi;

constexpr double length = 1;  // [m]
constexpr double wave = 100;  // [m/s]
constexpr double v0 = 0.1;    // [m/s]: strains of 1e-3, so that linear theory holds to that
constexpr double omega = pi * wave / (2 * length);
constexpr double period = 2 * pi / omega;

/// One cell high between two planes of symmetry, Poisson's ratio 0.
mpm::Scene bar(int cells) {
  mpm::Scene scene = samples::soft_body(2, 2 * cells, length / (2 * cells));
  scene.motion.left = scene.motion.bottom = scene.motion.top = mpm::Edge::symmetry;
  scene.motion.margin = 0.1;
  return scene;
}

/// Amplitude over v0, and phase less omega t, of the first mode.
struct Mode {
  double amplitude = 0, lag = 0;
};
Mode first_mode(const Moving<double>& it) {
  double v = 0, u = 0, norm = 0;
  for (const auto& p : it.solver.points()) {
    const double x = it.rest_place(p.id).x;
    const double shape = std::sin(0.5 * pi * x / length);
    v += p.mass * p.vx * shape;
    u += p.mass * (p.x - x) * shape;
    norm += p.mass * shape * shape;
  }
  const double phase = std::atan2(omega * u, v);
  const double lag = std::remainder(omega * it.solver.time() - phase, 2 * pi);
  return {std::hypot(v, omega * u) / (norm * v0), lag};
}

struct Outcome {
  Mode one, ten;      ///< after as many periods
  double energy = 0;  ///< after ten periods over that at the start [-]
};
Outcome vibrate(const Method& method, int cells, double cfl = 0.5) {
  mpm::Scene scene = bar(cells);
  scene.cfl = cfl;
  method.give_to(scene);
  Moving<double> it(scene);
  it.solver.kick(
      [](const mpm::PointView& p, double& vx, double&) { vx = v0 * std::sin(0.5 * pi * p.x / length); });
  const double start = samples::sums_of(it.solver).kinetic;
  Outcome outcome;
  mpm::Ledger ledger;
  while (it.solver.time() < period) ledger = it.solver.advance(1);
  outcome.one = first_mode(it);
  while (it.solver.time() < 10 * period) ledger = it.solver.advance(1);
  outcome.ten = first_mode(it);
  outcome.energy = (ledger.kinetic + ledger.elastic) / start;
  return outcome;
}

/// Phase lost in a period [-], from the first to the tenth, so that what the start costs does not count.
double lag(const Outcome& o) { return std::abs(o.ten.lag - o.one.lag) / (9 * 2 * pi); }

// Lumped mass, cells and steps of central differences each err by the square of their size: the period comes
// with second order in every method. FLIP and APIC give most of the energy back after ten periods; a blend
// loses what its share of PIC takes in each step.
void expect_second_order(mpm::Shape shape) {
  for (const Method& method : samples::all_methods(0.99)) {
    if (method.shape != shape) continue;
    SCOPED_TRACE(method.name());
    const Outcome coarse = vibrate(method, 8);
    const Outcome fine = vibrate(method, 16);
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

}  // namespace
