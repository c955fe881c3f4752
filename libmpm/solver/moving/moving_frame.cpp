// Moving points for those who look on.
#include <algorithm>

#include "libmpm/material/failure.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"

namespace mpm {

template <class Real>
FramePoint MovingSolver<Real>::frame_point(const Slot& slot) const {
  const PointView point = view(slot);
  const PointOrigin origin = origin_of(scene_, point.id);
  const moving::RecordLayout& layout = points_.layout();
  PointState state{.phase = origin.phase};
  state.kept = static_cast<double>(points_.value(slot, moving::shear)) /
               static_cast<double>(static_cast<Real>(stiffness(*origin.phase, scene_.plane)(2, 2)));
  if (layout.cracked >= 0) state.cracked = static_cast<double>(points_.value(slot, layout.cracked));
  // The record holds the stress with what is kept of the stiffness, but not yet what a crack takes of it.
  const PointState closed{.phase = origin.phase, .kept = 1, .cracked = state.cracked};
  const Stress<double> s = carried_stress(closed, point.stress, law_);
  return completed({.id = point.id, .x = point.x, .y = point.y, .vx = point.vx, .vy = point.vy},
                   {s.xx, s.yy, s.xy, state.kept, state.cracked}, scene_);
}

template <class Real>
void MovingSolver<Real>::fill(Frame& frame) const {
  frame.step = clock_.step;
  frame.time = clock_.time;
  frame.strain = nominal_strain();
  frame.points.clear();
  for (int row = 0; row < points_.rows(); ++row)
    points_.for_each(row, [&](const Slot& slot) { frame.points.push_back(frame_point(slot)); });
  std::sort(frame.points.begin(), frame.points.end(),
            [](const FramePoint& a, const FramePoint& b) { return a.id < b.id; });
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
