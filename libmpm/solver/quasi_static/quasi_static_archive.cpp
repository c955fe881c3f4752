// The state of a quasi-static run: in frames, into an archive and out of it.
#include <algorithm>

#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace mpm {

bool QuasiStaticSolver::has_failed(const Place& at) const {
  if (maps_.failure_mode.size() == 0) return false;
  if (equilibrium_.is_extra(at)) return maps_.extra_failure_mode[equilibrium_.extra(at).index] != 0;
  const Pixel pixel = equilibrium_.pixel(at);
  return maps_.failure_mode(pixel.row, pixel.col) != 0;
}

/// @param start  with the place where the point began, and its id.
FramePoint QuasiStaticSolver::frame_point(const Place& at, FramePoint start) const {
  const auto [xi, eta] = equilibrium_.in_cell(at);
  const CellDisplacement u = equilibrium_.displacement(at.row, at.cell);
  const auto moved = [&, x = xi, y = eta](const double(&v)[4]) {
    return sign_ * strain_ * ((1 - y) * ((1 - x) * v[0] + x * v[1]) + y * ((1 - x) * v[2] + x * v[3]));
  };
  start.x += moved(u.ux);
  start.y += moved(u.uy);
  PointState point = state_at(at, equilibrium_.index(at));
  double kept = point.kept;
  if (!is_live(kept)) {  // it has failed, or come loose
    point.kept = has_failed(at) ? scene_.damage.residual_stiffness : 0;
    kept = has_failed(at) ? scene_.damage.residual_stiffness : 1;
  }
  const Stress<double> s = carried_stress(point, elastic_at(limits_at(at), at, strain_), law_);
  return completed(start, {s.xx, s.yy, s.xy, kept, point.cracked}, scene_);
}

void QuasiStaticSolver::add_extra_points(Frame& frame) const {
  const auto first = static_cast<std::ptrdiff_t>(frame.points.size());
  for (int row = 0; row < plan_.cells_y; ++row)
    equilibrium_.each_extra(row, [&](const Place& at) {
      const std::size_t i = equilibrium_.extra(at).index;
      frame.points.push_back(frame_point(
          at, {.id = static_cast<std::uint32_t>(static_cast<std::size_t>(scene_.labels.size()) + i),
               .x = scene_.extra_points[i].x,
               .y = scene_.extra_points[i].y}));
    });
  std::sort(frame.points.begin() + first, frame.points.end(),
            [](const FramePoint& a, const FramePoint& b) { return a.id < b.id; });
}

void QuasiStaticSolver::fill(Frame& frame) const {
  frame.step = steps_;
  frame.time = 0;
  frame.strain = strain_;
  frame.points.clear();
  const int k = scene_.points_per_cell;
  const auto rows = static_cast<int>(scene_.labels.rows());
  const auto cols = static_cast<int>(scene_.labels.cols());
  for (int row = 0; row < rows; ++row)
    for (int col = 0; col < cols; ++col) {
      if (!scene_.phases[scene_.labels(row, col)]) continue;
      const int from_below = rows - 1 - row;
      const Place at{from_below / k, from_below % k * k + col % k, col / k};
      frame.points.push_back(frame_point(at, {.id = static_cast<std::uint32_t>(row * cols + col),
                                              .x = (col + 0.5) * scene_.pixel_size,
                                              .y = (from_below + 0.5) * scene_.pixel_size}));
    }
  add_extra_points(frame);
}

template <class Archive, class Self>
void QuasiStaticSolver::pass(Archive& archive, Self& self) {
  archive.whole(self.steps_, 1, std::int64_t{1} << 62);
  archive.finite(self.strain_);
  archive.finite(self.farthest_);
  archive.finite(self.modulus_);
  if (self.control_ >= 0) archive.finite(self.reading_);
  archive.finite(self.tally_.platen_work);
  archive.finite(self.tally_.released);
  archive.whole(self.tally_.tension_failures, 0, std::int64_t{1} << 62);
  archive.whole(self.tally_.shear_failures, 0, std::int64_t{1} << 62);
  archive.flag(self.done_);
  archive.flag(self.has_dropped_);
  archive.block(self.factors_);
  archive.block(self.strengths_);
  archive.block(self.cohesions_);
  archive.raw(&self.next_, 1);
  archive.block(self.equilibrium_.displacements().x);
  archive.block(self.equilibrium_.displacements().y);
  pass_maps(archive, self.maps_);
}

/// What points have gone through, but for their strengths.
template <class Archive, class Points>
void QuasiStaticSolver::pass_points(Archive& archive, Points& points) {
  archive.block(points.stiffness);
  archive.block(points.shear);
  archive.list(points.at);
  archive.list(points.kept);
  archive.list(points.cracked);
  archive.list(points.told);
}

void QuasiStaticSolver::save(ArchiveWriter& archive) const {
  pass(archive, *this);
  const Equilibrium::Points points = equilibrium_.all_points();
  pass_points(archive, points);
}

void QuasiStaticSolver::restore(ArchiveReader& archive) {
  const AlignedVector<double> intact = factors_;
  pass(archive, *this);
  Equilibrium::Points points = equilibrium_.all_points();
  pass_points(archive, points);
  if (!archive.ok()) return;
  for (std::size_t at = 0; at < intact.size(); ++at)
    if (factors_[at] != intact[at] && factors_[at] != 0) return archive.fail("a point of another strength");
  if (!equilibrium_.restore(points)) return archive.fail("points of an impossible stiffness");
  carrying_ = 0;
  each_point([&](const Place& at, std::size_t index) {
    if (intact[index] > 0) set_resistance(at, index);
    if (is_live(equilibrium_.kept(at))) ++carrying_;
  });
  find_onsets();
}

}  // namespace mpm
