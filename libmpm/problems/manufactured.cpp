#include "libmpm/problems/manufactured.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/problems/moving_body.hpp"

namespace mpm::problems {
namespace {

using std::numbers::pi;

constexpr double wave = 100;  // c [m/s]

struct Solution {
  double amplitude;  // A [m]
  double stiffness;  // (l + 2 m) / rho0 [m^2/s^2]

  [[nodiscard]] double u(double x, double t) const {
    return amplitude * std::sin(2 * pi * x) * std::sin(wave * pi * t);
  }
  [[nodiscard]] double start_velocity(double x) const { return wave * pi * amplitude * std::sin(2 * pi * x); }
  [[nodiscard]] double stretch(double x, double t) const {
    return 1 + 2 * pi * amplitude * std::cos(2 * pi * x) * std::sin(wave * pi * t);
  }
  [[nodiscard]] double body_force(double x, double across, double t) const {
    const double curvature = -4 * pi * pi * u(x, t);
    return -wave * wave * pi * pi * u(x, t) - stretch(across, t) * stiffness * curvature / stretch(x, t);
  }
};

/// Root of the mean square of the displacement's error [m].
template <class Real>
double error_now(const Moving<Real>& it, const Solution& exact) {
  double square = 0;
  int points = 0;
  for (const auto& p : it.solver.points()) {
    const Place rest = it.rest_place(p.id);
    square += std::pow(p.x - rest.x - exact.u(rest.x, it.solver.time()), 2) +
              std::pow(p.y - rest.y - exact.u(rest.y, it.solver.time()), 2);
    ++points;
  }
  return std::sqrt(square / points);
}

/// The step to come, whose length the fastest point decides [s].
template <class Real>
double next_step(const Moving<Real>& it) {
  if (it.solver.steps() == 0) return 0;
  double fastest = 0;
  for (const auto& p : it.solver.points()) fastest = std::max(fastest, std::hypot(p.vx, p.vy));
  return std::min(1.05 * it.solver.dt(), it.scene.cfl * it.plan.cell_size / (it.plan.wave_speed + fastest));
}

template <class Real>
Deformation deform(const Scene& scene, const Solution& exact) {
  Moving<Real> it(scene);
  it.solver.kick([&](const PointView& p, double& vx, double& vy) {
    vx = exact.start_velocity(p.x);
    vy = exact.start_velocity(p.y);
  });
  Deformation outcome;
  const double end = 1.5 / wave;
  while (it.solver.time() < end) {
    const double t = it.solver.time();
    const double dt = next_step(it);
    it.solver.kick([&](const PointView& p, double& vx, double& vy) {
      const Place rest = it.rest_place(p.id);
      vx += dt * exact.body_force(rest.x, rest.y, t);
      vy += dt * exact.body_force(rest.y, rest.x, t);
    });
    outcome.trouble = it.advance(1).trouble;
    if (!outcome.trouble.empty()) break;
    outcome.error = std::max(outcome.error, error_now(it, exact) / exact.amplitude);
  }
  outcome.cost = it.meter.cost();
  return outcome;
}

}  // namespace

Deformation deform_as_made_up(const Method& method, int cells, double amplitude, double cfl) {
  Scene scene = soft_body(2 * cells, 2 * cells, 0.5 / cells, 0.3);
  scene.motion.left = scene.motion.right = scene.motion.bottom = scene.motion.top = Edge::symmetry;
  scene.cfl = cfl;
  method.give_to(scene);
  const auto c = stiffness(*scene.phases[soft], scene.plane);
  const Solution exact{amplitude, c(0, 0) / scene.phases[soft]->density};
  return in_precision(method, [&](auto real) { return deform<decltype(real)>(scene, exact); });
}

}  // namespace mpm::problems
