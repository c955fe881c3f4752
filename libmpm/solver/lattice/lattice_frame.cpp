// The points of the lattice for those who look on. The state is that of the ledger, at the beginning of the
// last step: displacements of then, with what failed under them.
#include <algorithm>
#include <cmath>

#include "libmpm/solver/lattice/lattice_solver.hpp"

namespace mpm {

template <class Real>
FramePoint LatticeSolver<Real>::frame_point(const StartPoint& point, const PointState& state) const {
  const Stress<double> s = carried_stress(state, point.stress, law_);
  return completed({.id = point.id, .x = point.x, .y = point.y, .vx = point.vx, .vy = point.vy},
                   {s.xx, s.yy, s.xy, state.kept, state.cracked}, scene_);
}

template <class Real>
void LatticeSolver<Real>::add_pixels(Frame& frame) const {
  const int k = scene_.points_per_cell;
  const int rows = static_cast<int>(scene_.labels.rows());
  const int cols = static_cast<int>(scene_.labels.cols());
  for (int row = 0; row < rows; ++row) {
    const int from_below = rows - 1 - row;
    for (int col = 0; col < cols; ++col) {
      const auto& phase = scene_.phases[scene_.labels(row, col)];
      if (!phase) continue;
      const int cell_row = from_below / k;
      const int cell = col / k;
      StartPoint point = moved(cell_row, cell, (col % k + 0.5) / k, (from_below % k + 0.5) / k,
                               stiffness(*phase, scene_.plane), displacement_before(cell_row, cell));
      point.id = static_cast<std::uint32_t>(row * cols + col);
      const PointKind kind{&*phase, 1.0, shares_.size() > 0 ? 1.0 / shares_(row, col) : 1.0};
      const std::size_t at = points_.at(cell_row, from_below % k * k + col % k, cell);
      frame.points.push_back(frame_point(point, read_point(points_, at, scene_, plan_, kind)));
    }
  }
}

template <class Real>
void LatticeSolver<Real>::add_extra_points(Frame& frame) const {
  const auto first = static_cast<std::ptrdiff_t>(frame.points.size());
  for (std::size_t row = 0; row + 1 < extra_.row_begin.size(); ++row) {
    for (std::size_t i = extra_.row_begin[row]; i < extra_.row_begin[row + 1]; ++i) {
      const CellPoint& extra = extra_.points[i];
      StartPoint point = moved(static_cast<int>(row), extra.cell, extra.xi, extra.eta, extra.stiffness,
                               displacement_before(static_cast<int>(row), extra.cell));
      point.id = static_cast<std::uint32_t>(static_cast<std::size_t>(scene_.labels.size()) + extra.index);
      frame.points.push_back(frame_point(point, extra.state));
    }
  }
  std::sort(frame.points.begin() + first, frame.points.end(),
            [](const FramePoint& a, const FramePoint& b) { return a.id < b.id; });
}

template <class Real>
void LatticeSolver<Real>::fill(Frame& frame) const {
  frame.step = std::max<std::int64_t>(clock_.step - 1, 0);
  frame.time = static_cast<double>(frame.step) * plan_.dt;
  frame.strain = std::abs(clock_.displacement) / scene_.height();
  frame.points.clear();
  frame.points.reserve(static_cast<std::size_t>(all_points_));
  add_pixels(frame);
  if (!extra_.points.empty()) add_extra_points(frame);
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
