#include "libmpm/problems/flights.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/problems/method.hpp"

namespace mpm::problems {
namespace {

constexpr double middle = 0.5;  // of the disc [m]

/// Variance of the weights along an axis at a place `x` cells from a node [-].
double variance(Shape shape, double x) {
  const double place = x - std::floor(x);
  const double d = std::min(place, 1 - place);
  if (shape == Shape::linear) return place * (1 - place);
  const double l = shape == Shape::bspline ? 0.5 : 0.25;
  return (d < l ? (d * d + l * l) / (2 * l) : d) - d * d;
}

/// Angular momentum about the corner of the picture, with that of the affine part of APIC: its gradient acts
/// on the variance of the weights. Source: Jiang et al. (2015), section 5.3.
template <class Real>
double spin_of(const Moving<Real>& it) {
  const double h = it.plan.cell_size;
  const Shape shape = it.scene.motion.shape;
  double sum = 0;
  for (const auto& p : it.solver.points())
    sum += p.mass * (p.x * p.vy - p.y * p.vx + h * h * variance(shape, p.x / h) * p.gradient[2] -
                     h * h * variance(shape, p.y / h) * p.gradient[1]);
  return sum;
}

template <class Real>
Flight fly_in(const Scene& scene) {
  Moving<Real> it(scene);
  throw_disc(it, 10);
  Ledger ledger = it.advance(1);
  const Sums first = sums_of(it.solver);
  const double before = spin_of(it);
  while (it.solver.time() < 0.12 && ledger.trouble.empty()) ledger = it.advance(1);
  const Sums last = sums_of(it.solver);
  const double orbit = middle * first.py - middle * first.px;  // stays, because the momentum does
  Flight flight;
  flight.lost_spin = (before - spin_of(it)) / (before - orbit);
  flight.lost_momentum = std::hypot(last.px - first.px, last.py - first.py) / std::hypot(first.px, first.py);
  flight.cost = it.meter.cost();
  flight.trouble = ledger.trouble;
  return flight;
}

}  // namespace

Scene flying_disc(int cells) {
  const int pixels = 2 * cells;
  Scene scene = soft_body(pixels, pixels, 2 * middle / pixels, 0.2);
  keep_disc(scene, 0.5 * pixels, 0.5 * pixels, 0.45 * pixels);
  scene.motion.margin = 0.4;
  return scene;
}

Flight fly(const Method& method, int cells, double cfl) {
  Scene scene = flying_disc(cells);
  scene.cfl = cfl;
  method.give_to(scene);
  return in_precision(method, [&](auto real) { return fly_in<decltype(real)>(scene); });
}

namespace {

template <class Real>
Patch fly_in(const Scene& scene, int steps) {
  Moving<Real> it(scene);
  Patch patch;
  patch.trouble = it.advance(steps).trouble;
  const double time = it.solver.time();
  for (const auto& p : it.solver.points()) {
    const Place rest = it.rest_place(p.id);
    const double off = std::hypot(p.x - rest.x - scene.loading.initial_velocity_x * time,
                                  p.y - rest.y - scene.loading.initial_velocity_y * time);
    patch.strayed = std::max(patch.strayed, off / it.plan.cell_size);
    patch.stress =
        std::max(patch.stress, (std::abs(p.stress.xx) + std::abs(p.stress.yy) + std::abs(p.stress.xy)) /
                                   scene.phases[soft]->young);
  }
  patch.crossed = scene.loading.initial_velocity_x * time / it.plan.cell_size;
  patch.cost = it.meter.cost();
  return patch;
}

}  // namespace

Patch fly_uniformly(const Method& method, int cells, int steps) {
  Scene scene = soft_body(2 * cells, 2 * cells, 0.3 / cells, 0.2);
  add_irregular_points(scene, cells * cells + 4);
  scene.loading.initial_velocity_x = 3;
  scene.loading.initial_velocity_y = -2;
  scene.motion.margin = 0.5;
  method.give_to(scene);
  return in_precision(method, [&](auto real) { return fly_in<decltype(real)>(scene, steps); });
}

namespace {

Scene two_discs(int cells) {
  const int pixels = 2 * cells;
  Scene scene = soft_body(pixels, pixels, 1.0 / pixels, 0.3);
  for (int row = 0; row < pixels; ++row)
    for (int col = 0; col < pixels; ++col) {
      const double x = (col + 0.5) / pixels;
      const double y = 1 - (row + 0.5) / pixels;
      if (std::hypot(x - 0.275, y - 0.275) > 0.2 && std::hypot(x - 0.725, y - 0.725) > 0.2)
        scene.labels(row, col) = 0;
    }
  return scene;
}

template <class Real>
Collision collide_in(const Scene& scene) {
  constexpr double speed = 1.5;  // along each axis [m/s]
  Moving<Real> it(scene);
  it.solver.kick(
      [](const PointView& p, double& vx, double& vy) { vx = vy = p.x + p.y < 1 ? speed : -speed; });
  const Sums before = sums_of(it.solver);
  Collision outcome;
  Ledger ledger;
  while (it.solver.time() < 0.16 && ledger.trouble.empty()) {
    ledger = it.advance(10);
    outcome.most_energy = std::max(outcome.most_energy, (ledger.kinetic + ledger.elastic) / before.kinetic);
  }
  for (const auto& p : it.solver.points()) {
    const Place rest = it.rest_place(p.id);
    outcome.rebound += p.mass * (p.vx + p.vy) * (rest.x + rest.y < 1 ? -1 : 1) / (2 * speed * before.mass);
  }
  const Sums after = sums_of(it.solver);
  outcome.kept_energy = (ledger.kinetic + ledger.elastic) / before.kinetic;
  outcome.lost_momentum = std::hypot(after.px, after.py) / before.mass;
  outcome.cost = it.meter.cost();
  outcome.trouble = ledger.trouble;
  return outcome;
}

}  // namespace

Collision collide(const Method& method, int cells, double cfl) {
  Scene scene = two_discs(cells);
  scene.cfl = cfl;
  method.give_to(scene);
  return in_precision(method, [&](auto real) { return collide_in<decltype(real)>(scene); });
}

}  // namespace mpm::problems
