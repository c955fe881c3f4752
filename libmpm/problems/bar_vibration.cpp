#include "libmpm/problems/bar_vibration.hpp"

#include <cmath>
#include <numbers>

#include "libmpm/problems/moving_body.hpp"

namespace mpm::problems {
namespace {

using std::numbers::pi;

constexpr double length = 1;  // [m]
constexpr double wave = 100;  // [m/s]
constexpr double v0 = 0.1;    // [m/s]: strains of 1e-3, so that linear theory holds to that
constexpr double omega = pi * wave / (2 * length);
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

}  // namespace mpm::problems
