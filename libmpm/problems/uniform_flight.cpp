#include "libmpm/problems/uniform_flight.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/problems/moving_body.hpp"

namespace mpm::problems {
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

}  // namespace mpm::problems
