// Large deformation with a solution made up beforehand: u = A sin(2 pi X) sin(c pi t) along each axis of the
// unit square, driven by the body force that it needs.
//
// F = diag(Fx(X, t), Fy(Y, t)) turns nothing, so Jaumann's rate integrates to the Cauchy stress
// s_xx = (l + 2 m) ln Fx + l ln Fy. With P = J s F^-T, P_xx = Fy s_xx and the balance of momentum
// rho0 u_tt = P_xx,X + rho0 b, where ln Fy does not depend on X, the body force is
// b_x = u_tt - Fy (l + 2 m) Fx,X / (Fx rho0); b_y alike.
// Source: method of manufactured solutions for MPM, Steffen, Wallstedt, Guilkey, Kirby, Berzins, CMES 31 (2008).
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

struct Outcome {
  double error = 0;  ///< root of the mean square of the displacement's error, largest in time, over A
  int crossings = 0;
};

Outcome run(const Method& method, int cells, double amplitude, double cfl) {
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
  Outcome outcome;
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
    if (!ledger.trouble.empty()) {
      std::printf("%s\n", ledger.trouble.c_str());
      return {1, 0};
    }
    double square = 0;
    int points = 0;
    for (const auto& p : it.solver.points()) {
      const auto rest = it.rest_place(p.id);
      square += std::pow(p.x - rest.x - exact.u(rest.x, it.solver.time()), 2) +
                std::pow(p.y - rest.y - exact.u(rest.y, it.solver.time()), 2);
      ++points;
    }
    outcome.error = std::max(outcome.error, std::sqrt(square / points) / amplitude);
  }
  return outcome;
}

TEST(Manufactured, Figures) {
  for (const double amplitude : {1e-4, 0.05}) {
    for (const Method& method : samples::all_methods(0.9)) {
      // The body force comes as a kick before the step: USF would strain the points with it before the stress
      // has answered, which is first order in the step and says nothing of the scheme.
      if (method.flip_ratio < 1 || method.scheme == mpm::Scheme::usf) continue;
      std::vector<double> sizes, errors;
      for (const int cells : {8, 16, 32}) {
        sizes.push_back(1.0 / cells);
        errors.push_back(run(method, cells, amplitude, 0.4).error);
      }
      std::printf("A %.4f %-22s %.3e %.3e %.3e  order %.2f\n", amplitude, method.name().c_str(), errors[0], errors[1],
                  errors[2], samples::fitted_order(sizes, errors));
    }
  }
}

}  // namespace
