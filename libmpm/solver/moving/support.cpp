#include "libmpm/solver/moving/support.hpp"

namespace mpm {
namespace {

Support support_at(Edge edge) {
  switch (edge) {
    case Edge::closed:
    case Edge::open:
      break;
    case Edge::symmetry:
      return {.active = true};
    case Edge::smooth_wall:
      return {.active = true, .separates = true};
    case Edge::rough_wall:
      return {.active = true, .separates = true, .rough = true};
  }
  return {};
}

}  // namespace

Supports supports_of(const Scene& scene) {
  const Motion& motion = scene.motion;
  if (scene.loading.direction == Direction::none)
    return {support_at(motion.left), support_at(motion.right), support_at(motion.bottom),
            support_at(motion.top)};
  const Support platen{
      .active = true, .separates = scene.loading.separation, .rough = scene.loading.platen == Platen::rough};
  return {support_at(motion.left), support_at(motion.right), platen, platen};
}

}  // namespace mpm
