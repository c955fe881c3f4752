// Large deformation with a solution made up beforehand: u = A sin(2 pi X) sin(c pi t) along each axis of the
// unit square, driven by the body force that it needs.
//
// F = diag(Fx(X, t), Fy(Y, t)) turns nothing, so Jaumann's rate integrates to the Cauchy stress
// s_xx = (l + 2 m) ln Fx + l ln Fy. With P = J s F^-T, P_xx = Fy s_xx and the balance of momentum
// rho0 u_tt = P_xx,X + rho0 b, where ln Fy does not depend on X, the body force is
// b_x = u_tt - Fy (l + 2 m) Fx,X / (Fx rho0); b_y alike.
// Source: method of manufactured solutions for MPM, Steffen, Wallstedt, Guilkey, Kirby, Berzins, CMES 31
// (2008).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/verification/order.hpp"

namespace {

using samples::Method;
using samples::Moving;
using std::numbers::pi;

constexpr double wave = 100;  // c [m/s]

struct Solution {
  double amplitude;  // A [m]
  double stiffness;  // (l + 2 m) / rho0 [m^2/s^2]

  [[nodiscard]] double u(double x, double t) const {
    return amplitude * std::sin(2 * pi * x) * std::sin(wave * pi * t);
  }
  [[nodiscard]] double stretch(double x, double t) const {
    return 1 + 2 * pi * amplitude * std::cos(2 * pi * x) * std::sin(wave * pi * t);
  }
  [[nodiscard]] double body_force(double x, double across, double t) const {
    const double curvature = -4 * pi * pi * u(x, t);
    return -wave * wave * pi * pi * u(x, t) - stretch(across, t) * stiffness * curvature / stretch(x, t);
  }
};

/// Root of the mean square of the displacement's error, the largest in time, over A.
double error(const Method& method, int cells, double amplitude) {
  const double cfl = 0.4;
  mpm::Scene scene = samples::soft_body(2 * cells, 2 * cells, 0.5 / cells, 0.3);
  scene.motion.left = scene.motion.right = scene.motion.bottom = scene.motion.top = mpm::Edge::symmetry;
  scene.cfl = cfl;
  method.give_to(scene);
  Moving<double> it(scene);
  const auto c = mpm::stiffness(*scene.phases[samples::soft], scene.plane);
  const Solution exact{amplitude, c(0, 0) / 1000};
  const double speed = mpm::wave_speed(*scene.phases[samples::soft], scene.plane);
  it.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
    vx = wave * pi * exact.amplitude * std::sin(2 * pi * p.x);
    vy = wave * pi * exact.amplitude * std::sin(2 * pi * p.y);
  });
  double worst = 0;
  const double end = 1.5 / wave;  // out, back and through
  while (it.solver.time() < end) {
    // The impulse of the body force is that of the step to come, whose length the fastest point decides.
    double fastest = 0;
    for (const auto& p : it.solver.points()) fastest = std::max(fastest, std::hypot(p.vx, p.vy));
    const double t = it.solver.time();
    const double dt = t > 0 ? std::min(1.05 * it.solver.dt(), cfl / cells / (speed + fastest)) : 0;
    it.solver.kick([&](const mpm::PointView& p, double& vx, double& vy) {
      const auto rest = it.rest_place(p.id);
      vx += dt * exact.body_force(rest.x, rest.y, t);
      vy += dt * exact.body_force(rest.y, rest.x, t);
    });
    const mpm::Ledger ledger = it.solver.advance(1);
    EXPECT_EQ(ledger.trouble, "");
    if (!ledger.trouble.empty()) return 1e3;
    double square = 0;
    int points = 0;
    for (const auto& p : it.solver.points()) {
      const auto rest = it.rest_place(p.id);
      square += std::pow(p.x - rest.x - exact.u(rest.x, it.solver.time()), 2) +
                std::pow(p.y - rest.y - exact.u(rest.y, it.solver.time()), 2);
      ++points;
    }
    worst = std::max(worst, std::sqrt(square / points) / amplitude);
  }
  return worst;
}

double order(const Method& method, double amplitude, const std::vector<int>& grids) {
  std::vector<double> sizes, errors;
  for (const int cells : grids) {
    sizes.push_back(1.0 / cells);
    errors.push_back(error(method, cells, amplitude));
  }
  const double result = samples::fitted_order(sizes, errors);
  if (samples::figures)
    std::printf("A %.4f %-16s error %.2e .. %.2e order %.2f\n", amplitude, method.name().c_str(),
                errors.front(), errors.back(), result);
  return result;
}

// The body force comes as a kick before the step. USF would strain the points with it before the stress has
// answered, which is of first order in the step and says nothing of the scheme: left out here.
std::vector<Method> methods(mpm::Shape shape) {
  std::vector<Method> all;
  for (const auto scheme : {mpm::Scheme::usl, mpm::Scheme::musl})
    for (const auto transfer : {mpm::Transfer::flip, mpm::Transfer::apic})
      all.push_back({shape, scheme, transfer, 1});
  return all;
}

// While no point crosses a cell every shape is of second order.
TEST(Manufactured, SmallDeformationIsOfSecondOrderWithEveryShape) {
  for (const auto shape : samples::all_shapes())
    for (const Method& method : methods(shape)) EXPECT_GT(order(method, 1e-4, {8, 16}), 1.9) << method.name();
}

// Displacements of 0.05 take points over up to two cells. The gradient of linear shapes jumps there, by an
// amount that does not fall with the cell: no convergence. Smooth shapes keep close to second order with
// FLIP; APIC smooths with a viscosity of about c h, so that it falls to first order, at a smaller error on
// coarse grids. Source: Steffen, Kirby, Berzins, IJNME 76 (2008), on the errors of quadrature and of
// crossing.
TEST(Manufactured, LinearShapesDoNotConvergeOnceTheyCrossCells) {
  EXPECT_LT(order({mpm::Shape::linear, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 0.6);
  EXPECT_LT(order({mpm::Shape::linear, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.6);
}
TEST(Manufactured, GimpConvergesOverCells) {
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 1.7);
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::usl}, 0.05, {8, 16}), 1.5);
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.9);
}
TEST(Manufactured, BSplinesConvergeOverCells) {
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 1.7);
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::usl}, 0.05, {8, 16}), 1.5);
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.9);
}

}  // namespace
