#include "libmpm/problems/disc_flight.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace mpm::problems
