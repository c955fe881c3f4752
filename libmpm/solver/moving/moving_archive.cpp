// The state of a run of moving points, into an archive and out of it.
// Moving points for those who look on.
#include <algorithm>
#include <limits>

#include "libmpm/material/failure.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/failure_maps.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"

namespace mpm {

/// Records as they lie in the storage, empty lanes too: sums over points are taken in the order of the slots,
/// and a point that comes takes the first that is free.
template <class Real>
void MovingPoints<Real>::save(ArchiveWriter& archive) const {
  archive.whole(lanes_, 0, 0);
  archive.whole(layout_.fields, 0, 0);
  const auto lanes = static_cast<std::size_t>(lanes_);
  const auto record_size = static_cast<std::size_t>(layout_.fields) * lanes;
  for (const Row& row : rows_) {
    archive.block(row.used);
    for (std::size_t block = 0; block < row.used.size(); ++block) {
      const auto begin = static_cast<std::size_t>(row.begin[block]);
      const auto count = static_cast<std::size_t>(row.used[block]);
      archive.raw(row.records.data() + begin * record_size, count * record_size);
      archive.raw(row.ids.data() + begin * lanes, count * lanes);
    }
  }
}

template <class Real>
void MovingPoints<Real>::restore(ArchiveReader& archive) {
  int lanes = lanes_;
  int fields = layout_.fields;
  archive.whole(lanes, lanes_, lanes_);
  archive.whole(fields, layout_.fields, layout_.fields);
  for (Row& row : rows_) restore_row(row, archive);
}

template <class Real>
void MovingPoints<Real>::restore_row(Row& row, ArchiveReader& archive) {
  const auto lanes = static_cast<std::size_t>(lanes_);
  const auto record_size = static_cast<std::size_t>(layout_.fields) * lanes;
  std::vector<std::int32_t> used(row.used.size());
  archive.block(used);
  std::size_t records = 0;
  for (const std::int32_t count : used) {
    if (count < 0) return archive.fail("a negative number of records");
    records += static_cast<std::size_t>(count);
  }
  // Places in a row are of 32 bits.
  const std::size_t most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) / record_size;
  if (records > most || !archive.holds(records, record_size * sizeof(Real))) archive.fail("too short");
  if (!archive.ok()) return;
  row.records.resize(records * record_size);
  row.ids.resize(records * lanes);
  std::size_t begin = 0;
  for (std::size_t block = 0; block < used.size(); ++block) {
    const auto count = static_cast<std::size_t>(used[block]);
    (void)archive.raw(row.records.data() + begin * record_size, count * record_size);
    (void)archive.raw(row.ids.data() + begin * lanes, count * lanes);
    row.begin[block] = static_cast<std::int32_t>(begin);
    begin += count;
  }
  row.capacity = row.used = std::move(used);
}

/// What there is of points, once all rows are there.
template <class Real>
void MovingPoints<Real>::count_points() {
  for (int index = 0; index < rows(); ++index) {
    std::int64_t& points = rows_[static_cast<std::size_t>(index)].points;
    points = 0;
    for_each(index, [&](const Slot&) { ++points; });
  }
}

namespace {

/// Points of the scene by their ids, each at most once.
template <class Real>
void check_points(const MovingPoints<Real>& points, const Scene& scene, ArchiveReader& archive) {
  const auto pixels = static_cast<std::size_t>(scene.labels.size());
  std::vector<bool> seen(pixels + scene.extra_points.size());
  const auto is_solid = [&](std::uint32_t id) {
    const std::uint8_t label = id < pixels ? scene.labels.data()[id] : scene.extra_points[id - pixels].phase;
    return scene.phases[label].has_value();
  };
  for (int row = 0; row < points.rows(); ++row)
    points.for_each(row, [&](const auto& slot) {
      const std::uint32_t id = points.id(slot);
      if (id >= seen.size() || seen[id] || !is_solid(id))
        return archive.fail("a point that is not in the scene");
      seen[id] = true;
    });
}

}  // namespace

/// All but the points. What the next step makes anew is left out: the nodes, sums of single steps, bands.
template <class Real>
template <class Archive, class Self>
void MovingSolver<Real>::pass(Archive& archive, Self& self) {
  constexpr std::int64_t many = std::int64_t{1} << 62;  // room to count on
  archive.whole(self.clock_.step, 0, many);
  for (auto* number : {&self.clock_.time, &self.clock_.dt, &self.clock_.displacement, &self.clock_.velocity,
                       &self.first_dt_, &self.force_top_, &self.force_bottom_, &self.reported_displacement_,
                       &self.reported_time_, &self.left_energy_})
    archive.finite(*number);
  archive.whole(self.left_, 0, many);
  archive.whole(self.pinned_, -1, self.geometry_.nodes_x - 1);
  archive.block(self.contact_);
  archive.block(self.row_damped_);
  archive.block(self.row_released_);
  for (auto& count : self.live_) archive.whole(count, 0, many >> 8U);
  auto& tally = self.sums_;
  for (auto* number : {&tally.platen_work, &tally.released, &tally.damped}) archive.finite(*number);
  archive.whole(tally.tension_failures, 0, many);
  archive.whole(tally.shear_failures, 0, many);
  pass_maps(archive, self.maps_);
}

template <class Real>
void MovingSolver<Real>::save(ArchiveWriter& archive) const {
  pass(archive, *this);
  Real fastest = start_fastest_;
  for (const Band& band : bands_) fastest = std::max(fastest, band.fastest);
  archive.finite(fastest);
  points_.save(archive);
}

template <class Real>
void MovingSolver<Real>::restore(ArchiveReader& archive) {
  pass(archive, *this);
  start_ = sums_;  // with the failures that bands have counted; those of this solver begin at none
  archive.finite(start_fastest_);
  points_.restore(archive);
  if (!archive.ok()) return;
  points_.count_points();
  check_points(points_, scene_, archive);
}

template class MovingPoints<float>;
template class MovingPoints<double>;

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
