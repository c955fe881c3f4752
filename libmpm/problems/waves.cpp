#include "libmpm/problems/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libmpm/problems/method.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"

namespace mpm::problems {
namespace {

using std::numbers::pi;

constexpr double length = 1;      // [m]
constexpr double bar_wave = 100;  // [m/s]
constexpr double v0 = 0.1;        // [m/s]: strains of 1e-3, so that linear theory holds to that
constexpr double omega = pi * bar_wave / (2 * length);
constexpr double period = 2 * pi / omega;

/// One cell high between two planes of symmetry, Poisson's ratio 0.
Scene bar(int cells) {
  Scene scene = soft_body(2, 2 * cells, length / (2 * cells));
  scene.motion.left = scene.motion.bottom = scene.motion.top = Edge::symmetry;
  scene.motion.margin = 0.1;
  return scene;
}

double shape_at(double x) { return std::sin(0.5 * pi * x / length); }

template <class Real>
Mode first_mode(const Moving<Real>& it) {
  double v = 0, u = 0, norm = 0;
  for (const auto& p : it.solver.points()) {
    const double x = it.rest_place(p.id).x;
    const double shape = shape_at(x);
    v += p.mass * p.vx * shape;
    u += p.mass * (p.x - x) * shape;
    norm += p.mass * shape * shape;
  }
  const double phase = std::atan2(omega * u, v);
  const double lag = std::remainder(omega * it.solver.time() - phase, 2 * pi);
  return {std::hypot(v, omega * u) / (norm * v0), lag};
}

template <class Real>
double distance(const Moving<Real>& it) {
  double square = 0, norm = 0;
  for (const auto& p : it.solver.points()) {
    const double x = it.rest_place(p.id).x;
    const double u = v0 / omega * shape_at(x) * std::sin(omega * it.solver.time());
    const double v = v0 * shape_at(x) * std::cos(omega * it.solver.time());
    square += std::pow(omega * (p.x - x - u), 2) + std::pow(p.vx - v, 2);
    norm += std::pow(v0 * shape_at(x), 2);
  }
  return std::sqrt(square / norm);
}

template <class Real>
Vibration vibrate(const Scene& scene) {
  Moving<Real> it(scene);
  it.solver.kick([](const PointView& p, double& vx, double&) { vx = v0 * shape_at(p.x); });
  const double start = sums_of(it.solver).kinetic;
  Vibration outcome;
  Ledger ledger;
  const auto go_to = [&](double time) {
    while (it.solver.time() < time && ledger.trouble.empty()) ledger = it.advance(1);
  };
  go_to(period);
  outcome.one = first_mode(it);
  go_to(10 * period);
  outcome.ten = first_mode(it);
  outcome.energy = (ledger.kinetic + ledger.elastic) / start;
  outcome.error = distance(it);
  outcome.cost = it.meter.cost();
  outcome.trouble = ledger.trouble;
  return outcome;
}

}  // namespace

Vibration vibrate_bar(const Method& method, int cells, double cfl) {
  Scene scene = bar(cells);
  scene.cfl = cfl;
  method.give_to(scene);
  return in_precision(method, [&](auto real) { return vibrate<decltype(real)>(scene); });
}

namespace {

/// Platens that move by nothing within the run.
Scene bar_of_pixels(int cells) {
  Scene scene = soft_body(2 * cells, 2, length / cells);
  scene.kinematics = Kinematics::small_strain;
  scene.pixel_cells = true;
  scene.points_per_cell = 1;
  scene.loading = {};
  scene.loading.velocity = 1e-9;
  scene.loading.ramp_time = 0;
  scene.loading.stop_strain = scene.loading.velocity * 10 * period / scene.height();
  scene.threads = 1;
  return scene;
}

/// Displacements are known at the end of a step, velocities half a step before.
double distance(const std::vector<StartPoint>& points, const Scene& scene, double time, double dt) {
  double square = 0, norm = 0;
  for (const StartPoint& p : points) {
    const double y = rest_place(scene, p.id).y;
    const double u = v0 / omega * shape_at(y) * std::sin(omega * time);
    const double v = v0 * shape_at(y) * std::cos(omega * (time - 0.5 * dt));
    square += std::pow(omega * (p.y - y - u), 2) + std::pow(p.vy - v, 2);
    norm += std::pow(v0 * shape_at(y), 2);
  }
  return std::sqrt(square / norm);
}

}  // namespace

Vibration vibrate_bar_of_pixels(int cells, double cfl) {
  Scene scene = bar_of_pixels(cells);
  scene.cfl = cfl;
  const Plan plan = mpm::plan(scene);
  LatticeSolver<double> solver(scene, plan);
  solver.kick([&](double, double y, double&, double& vy) {
    vy = v0 * shape_at(y) * std::cos(0.5 * omega * plan.dt);
  });
  Meter meter(count_points(scene));
  const Ledger ledger = meter.advance(solver, 1'000'000'000);
  Vibration outcome;
  outcome.cost = meter.cost();
  outcome.trouble = ledger.trouble;
  outcome.error =
      distance(solver.hand_over().points, scene, static_cast<double>(solver.steps()) * plan.dt, plan.dt);
  return outcome;
}

namespace {

using std::numbers::pi;

constexpr double square_wave = 100;  // c [m/s]

struct Solution {
  double amplitude;  // A [m]
  double stiffness;  // (l + 2 m) / rho0 [m^2/s^2]

  [[nodiscard]] double u(double x, double t) const {
    return amplitude * std::sin(2 * pi * x) * std::sin(square_wave * pi * t);
  }
  [[nodiscard]] double start_velocity(double x) const {
    return square_wave * pi * amplitude * std::sin(2 * pi * x);
  }
  [[nodiscard]] double stretch(double x, double t) const {
    return 1 + 2 * pi * amplitude * std::cos(2 * pi * x) * std::sin(square_wave * pi * t);
  }
  [[nodiscard]] double body_force(double x, double across, double t) const {
    const double curvature = -4 * pi * pi * u(x, t);
    return -square_wave * square_wave * pi * pi * u(x, t) -
           stretch(across, t) * stiffness * curvature / stretch(x, t);
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
  const double end = 1.5 / square_wave;
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
