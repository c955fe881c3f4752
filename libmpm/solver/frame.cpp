#include "libmpm/solver/frame.hpp"

#include <algorithm>

#include "libmpm/solver/moving_start.hpp"

namespace mpm {
namespace {

/// Place of a point at the start [m].
struct Place {
  double x, y;
};
Place start_of(const Scene& scene, const PointOrigin& origin) {
  if (origin.row < 0) {
    const ExtraPoint& extra = scene.extra_points[origin.extra];
    return {extra.x, extra.y};
  }
  return {(origin.col + 0.5) * scene.pixel_size,
          (static_cast<double>(scene.labels.rows()) - origin.row - 0.5) * scene.pixel_size};
}

}  // namespace

FramePoint completed(FramePoint point, const FrameState& state, const Scene& scene) {
  const PointOrigin origin = origin_of(scene, point.id);
  const Place start = start_of(scene, origin);
  point.phase = origin.label;
  point.ux = point.x - start.x;
  point.uy = point.y - start.y;
  point.sxx = state.sxx;
  point.syy = state.syy;
  point.sxy = state.sxy;
  point.szz = scene.plane == Plane::strain ? origin.phase->poisson * (state.sxx + state.syy) : 0;
  const double lost = (1 - state.kept) / (1 - scene.damage.residual_stiffness);
  point.damage = std::clamp(std::max(lost, state.cracked), 0.0, 1.0);
  return point;
}

}  // namespace mpm
