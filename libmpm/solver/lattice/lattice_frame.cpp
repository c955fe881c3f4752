// Frames of the lattice, and the point where a run at small strain went wrong. The state is that of the
// ledger, at the beginning of the last step: displacements of then, with what failed under them.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

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

/// Keeps the first node of a row that is no number; where only their sum is none, the fastest one.
template <class Real>
void LatticeSolver<Real>::note_loss(Band& band, int row, const Clock& clock) const {
  const bool is_later = clock.step > band.loss.step || row > band.loss.row;  // the lowest row is swept last
  if (band.loss.step >= 0 && is_later) return;
  std::atomic_ref(band.loss.step).store(clock.step, std::memory_order_relaxed);
  band.loss.row = row;
  band.loss.col = 0;
  double fastest = -1;
  for (int col = 0; col < grid_.cols; ++col) {
    const auto at = static_cast<std::size_t>(grid_.at(row, col));
    const double speed = std::hypot(grid_.vx[at], grid_.vy[at]);
    if (speed <= fastest) continue;
    band.loss.col = col;
    if (!std::isfinite(speed)) return;
    fastest = speed;
  }
}

/// Whether a band has met with one up to this step. Others may be in the next step already, and what they
/// meet there does not count: all bands come to the same answer.
template <class Real>
bool LatticeSolver<Real>::is_lost(const Clock& clock) {
  return std::any_of(bands_.begin(), bands_.end(), [&](Band& band) {
    const std::int64_t step = std::atomic_ref(band.loss.step).load(std::memory_order_relaxed);
    return step >= 0 && step <= clock.step;
  });
}

/// The same for any number of bands.
template <class Real>
typename LatticeSolver<Real>::Loss LatticeSolver<Real>::first_loss() const {
  Loss first;
  for (const Band& band : bands_) {
    const Loss& loss = band.loss;
    if (loss.step < 0) continue;
    if (first.step < 0 || std::tie(loss.step, loss.row) < std::tie(first.step, first.row)) first = loss;
  }
  return first;
}

/// The nearest point of the cells round a node, by name; empty when they are void.
template <class Real>
std::string LatticeSolver<Real>::point_at_node(int row, int col) const {
  const int k = scene_.points_per_cell;
  const auto rows = static_cast<int>(scene_.labels.rows());
  const auto cols = static_cast<int>(scene_.labels.cols());
  double nearest = Phase::unbreakable;
  std::uint32_t id = 0;
  for (int from_below = std::max(0, (row - 1) * k); from_below < std::min(rows, (row + 1) * k);
       ++from_below) {
    for (int pixel = std::max(0, (col - 1) * k); pixel < std::min(cols, (col + 1) * k); ++pixel) {
      const int pixel_row = rows - 1 - from_below;
      if (!scene_.phases[scene_.labels(pixel_row, pixel)]) continue;
      const double distance = std::hypot(from_below + 0.5 - row * k, pixel + 0.5 - col * k);
      if (distance >= nearest) continue;
      nearest = distance;
      id = static_cast<std::uint32_t>(pixel_row * cols + pixel);
    }
  }
  return nearest < Phase::unbreakable ? name_of_point(scene_, id) : std::string();
}

template <class Real>
std::string LatticeSolver<Real>::worst_point() const {
  if (const Loss loss = first_loss(); loss.step >= 0) return point_at_node(loss.row, loss.col);
  double most = 0;
  std::uint32_t worst = 0;
  const auto compare = [&](std::uint32_t id, const PointState& point, const Stress<double>& elastic) {
    const double energy =
        stress_power(*point.phase, scene_.plane, carried_stress(point, elastic, law_), elastic);
    if (energy <= most) return;
    most = energy;
    worst = id;
  };
  const int k = scene_.points_per_cell;
  const auto rows = static_cast<int>(scene_.labels.rows());
  const auto cols = static_cast<int>(scene_.labels.cols());
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const auto& phase = scene_.phases[scene_.labels(row, col)];
      if (!phase) continue;
      const int from_below = rows - 1 - row;
      const std::size_t at = points_.at(from_below / k, from_below % k * k + col % k, col / k);
      compare(static_cast<std::uint32_t>(row * cols + col), state_of(row, col, at),
              stress_in_cell(stiffness(*phase, scene_.plane), displacement(from_below / k, col / k),
                             (col % k + 0.5) / k, (from_below % k + 0.5) / k, plan_.cell_size));
    }
  }
  for (std::size_t row = 0; row + 1 < extra_.row_begin.size(); ++row)
    for (std::size_t i = extra_.row_begin[row]; i < extra_.row_begin[row + 1]; ++i) {
      const CellPoint& point = extra_.points[i];
      compare(static_cast<std::uint32_t>(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols) +
                                         point.index),
              point.state,
              stress_in_cell(point.stiffness, displacement(static_cast<int>(row), point.cell), point.xi,
                             point.eta, plan_.cell_size));
    }
  return most > 0 ? name_of_point(scene_, worst) : std::string();
}

template class LatticeSolver<float>;
template class LatticeSolver<double>;

}  // namespace mpm
