// Moving points on their way into the solver and out of it.
#include "libmpm/solver/moving/moving_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/material/strength.hpp"
#include "libmpm/solver/threshold.hpp"

namespace mpm {
namespace {

/// Mass of the lightest pixel that the scene can hold [kg/m].
double lightest_point(const Scene& scene) {
  double lightest = Phase::unbreakable;
  for (const auto label : scene.labels.reshaped())
    if (scene.phases[label]) lightest = std::min(lightest, scene.phases[label]->density);
  for (const auto& point : scene.extra_points)
    if (scene.phases[point.phase]) lightest = std::min(lightest, scene.phases[point.phase]->density);
  return lightest * scene.pixel_size * scene.pixel_size;
}

template <class Real>
moving::Integrate<Real> undamped_integrate(const Scene& scene, moving::Features features) {
  features.damping = false;
  return chosen_moving_kernels(scene.instruction_set).template sweeps<Real>(features).integrate;
}

/// Rows of a band: no two may meet in one row of nodes with a third.
int least_rows(const MovingGeometry& geometry) { return geometry.reach - 1; }

/// The tile of `count` in which a place lies, from 0 on; the nearest one for a place outside, the first for
/// none.
int tile_at(double place, int count) {
  return place >= 1 ? static_cast<int>(std::min(place, count - 1.0)) : 0;
}

}  // namespace

template <class Real>
MovingSolver<Real>::MovingSolver(const Scene& scene, const Plan& plan, MovingStart start)
    : scene_(scene),
      plan_(plan),
      sweeps_(chosen_moving_kernels(scene.instruction_set).template sweeps<Real>(plan.moving.features)),
      integrate_undamped_(undamped_integrate<Real>(scene, plan.moving.features)),
      geometry_(moving_geometry(scene, plan)),
      supports_(supports_of(scene)),
      law_(damage_law(scene, plan.moving.crack_band, true)),
      factors_(scene, plan.softens),
      grid_(make_moving_grid<Real>(geometry_)),
      team_(most_bands(plan.threads, geometry_)),
      bands_(make_bands(scene, team_.threads())),
      points_(geometry_.tiles_y, geometry_.tiles_x, sweeps_.lanes, record_layout(plan.moving.optional)),
      contact_(grid_.mass.size(), std::uint8_t{0}),
      row_impulses_(static_cast<std::size_t>(geometry_.nodes_y)),
      row_damped_(static_cast<std::size_t>(geometry_.nodes_y), 0.0),
      row_released_(static_cast<std::size_t>(geometry_.tiles_y), 0.0),
      live_(scene.phases.size(), 0),
      speeds_(scene.phases.size(), 0.0),
      start_(start.tally),
      sums_(start.tally),
      maps_(std::move(start.maps)) {
  clock_.step = start.step;
  clock_.time = reported_time_ = start.time;
  clock_.displacement = reported_displacement_ = start.platen_displacement;
  clock_.velocity = start.platen_velocity;
  for (std::size_t label = 0; label < scene.phases.size(); ++label)
    if (scene.phases[label]) speeds_[label] = wave_speed(*scene.phases[label], scene.plane);
  const double lightest = lightest_point(scene);
  // Lighter nodes take part in nothing, and the forces on them are lost: at the edge of a quadratic shape
  // these fall with the root of the mass, to 1e-10 of those on other nodes.
  least_mass_ = static_cast<Real>(1e-20 * lightest);
  // A point alone on a node of weight S swings with c / (h sqrt S), for which the step that suits a full cell
  // is too long below S = cfl^2 / 4; four times that leaves room for several such nodes at a point. Where the
  // stress follows the new velocity of the nodes (USL), lighter nodes answer to forces as if they had that
  // mass.
  light_mass_ = static_cast<Real>(scene.cfl * scene.cfl * lightest);
  slopes_from_straining_ = scene.motion.transfer == Transfer::apic && scene.motion.shape == Shape::linear;
  step_.half_size = static_cast<Real>(plan.moving.half_size);
  step_.hx = static_cast<Real>(plan.cell_size);
  step_.flip_ratio = static_cast<Real>(scene.motion.flip_ratio);
  step_.unilateral = static_cast<Real>(scene.damage.crack_closure == CrackClosure::unilateral ? 1 : 0);
  reserve_points(start);
  load_points(start);
  for (Band& band : bands_) band.flags.assign(static_cast<std::size_t>(points_.blocks()), 0);
}

/// That can have enough rows.
template <class Real>
int MovingSolver<Real>::most_bands(int threads, const MovingGeometry& geometry) {
  return std::clamp(threads, 1, std::max(1, geometry.tiles_y / least_rows(geometry)));
}

/// Without rows yet.
template <class Real>
std::vector<typename MovingSolver<Real>::Band> MovingSolver<Real>::make_bands(const Scene& scene, int count) {
  std::vector<Band> bands(static_cast<std::size_t>(count));
  for (Band& band : bands) band.failed.assign(scene.phases.size(), 0);
  return bands;
}

/// By row of tiles, in sweeps over a record; the nodes of a block take about half as long.
template <class Real>
std::vector<std::int64_t> MovingSolver<Real>::work_of_rows() const {
  std::vector<std::int64_t> work;
  for (int row = 0; row < points_.rows(); ++row) {
    std::int64_t halves = points_.blocks();
    for (int block = 0; block < points_.blocks(); ++block) halves += 2 * points_.used(row, block);
    work.push_back(halves / 2 + 1);
  }
  return work;
}

/// Cuts the rows into bands of like work, when those at hand differ by more than a twentieth: points wander.
template <class Real>
void MovingSolver<Real>::share_rows() {
  const std::vector<std::int64_t> work = work_of_rows();
  const auto sum_of = [&](int begin, int end) {
    return std::accumulate(work.begin() + begin, work.begin() + end, std::int64_t{0});
  };
  const auto count = static_cast<std::int64_t>(bands_.size());
  const std::int64_t all = sum_of(0, geometry_.tiles_y);
  const bool fair = std::all_of(bands_.begin(), bands_.end(), [&](const Band& band) {
    return band.end > band.begin && 20 * count * sum_of(band.begin, band.end) <= 21 * all;
  });
  if (fair) return;
  const int least = least_rows(geometry_);
  std::vector<int> ends;
  int row = 0;
  std::int64_t done = 0;
  for (std::int64_t i = 1; i <= count; ++i) {
    const int first = row + least;
    const int last = geometry_.tiles_y - least * static_cast<int>(count - i);
    // A row goes to the band that holds the middle of its work.
    const auto is_mine = [&] {
      return count * (2 * done + work[static_cast<std::size_t>(row)]) <= 2 * i * all;
    };
    while (row < last && (row < first || i == count || is_mine()))
      done += work[static_cast<std::size_t>(row++)];
    ends.push_back(row);
  }
  bool same = true;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    bands_[i].begin = i == 0 ? 0 : ends[i - 1];
    same &= std::exchange(bands_[i].end, ends[i]) == ends[i];
  }
  if (same) return;
  momentum_ = TileSums<Real>(geometry_, 3, ends);
  force_ = TileSums<Real>(geometry_, 2, ends);
  if (plan_.moving.mapped_back) new_momentum_ = TileSums<Real>(geometry_, 2, ends);
}

template <class Real>
double MovingSolver<Real>::cell_height(double displacement) const {
  return (plan_.cell_size * geometry_.cells_y + displacement) / geometry_.cells_y;
}

template <class Real>
TilePlace MovingSolver<Real>::place_of(double x, double y, Real& xi, Real& eta) const {
  const double tile_x = (x - geometry_.left) / plan_.cell_size - geometry_.tile_offset;
  const double tile_y = (y - geometry_.bottom) / cell_height(clock_.displacement) - geometry_.tile_offset;
  const int col = tile_at(tile_x, geometry_.tiles_x), row = tile_at(tile_y, geometry_.tiles_y);
  xi = static_cast<Real>(tile_x - col);
  eta = static_cast<Real>(tile_y - row);
  return {row, col};
}

template <class Real>
typename MovingSolver<Real>::Loose MovingSolver<Real>::loose_point(const StartPoint& point) const {
  using namespace moving;
  const PointOrigin origin = origin_of(scene_, point.id);
  const Phase& phase = *origin.phase;
  const Eigen::Matrix3d c = stiffness(phase, scene_.plane);
  Loose loose;
  loose.id = point.id;
  auto& v = loose.values;
  loose.tile = place_of(point.x, point.y, v[xi], v[eta]);
  v[vx] = static_cast<Real>(point.vx);
  v[vy] = static_cast<Real>(point.vy);
  v[mass] = static_cast<Real>(point.mass);
  v[volume] = static_cast<Real>(point.volume);
  v[sxx] = static_cast<Real>(point.stress.xx);
  v[syy] = static_cast<Real>(point.stress.yy);
  v[sxy] = static_cast<Real>(point.stress.xy);
  v[lame] = static_cast<Real>(point.kept * c(0, 1));
  v[shear] = static_cast<Real>(point.kept * c(2, 2));
  const RecordLayout& layout = points_.layout();
  const auto at = [&](int field) -> Real& { return v[static_cast<std::size_t>(field)]; };
  PointState state = intact_point(phase, factor_of(factors_, origin));
  state.kept = point.kept;
  state.cracked = point.cracked;
  if (point.strength >= 0) state.strength = point.strength;
  state.spent |= point.ghost;
  write_state(state, v.data(), 1);
  if (layout.deformation >= 0) at(layout.deformation) = at(layout.deformation + 3) = 1;
  return loose;
}

/// What the sweeps need to know of the state of a point, into the fields of its record.
/// @param stride  from a field to the next.
template <class Real>
void MovingSolver<Real>::write_state(const PointState& state, Real* fields, int stride) const {
  const auto at = [&](int field) -> Real& { return fields[field * stride]; };
  const moving::RecordLayout& layout = points_.layout();
  const auto threshold = [&](double stress) {
    return static_cast<Real>(state.spent ? kernels::unreachable : stored_threshold(stress, 1));
  };
  if (layout.tension >= 0) at(layout.tension) = threshold(state.strength);
  if (layout.crush >= 0) {
    const double largest = state.cracked == 1 ? 0 : tension_threshold(*state.phase, state.factor);
    at(layout.crush) =
        threshold(shear_onset(*state.phase, state.factor, largest, remaining_cohesion(state, law_)));
  }
  if (layout.cracked >= 0) at(layout.cracked) = static_cast<Real>(state.cracked);
}

namespace {

template <class Visit>
void for_each_point(const MovingStart& start, const Scene& scene, const Visit& visit) {
  if (start.as_pictured) for_each_start_point(scene, visit);
  for (const StartPoint& point : start.points) visit(point);
}

}  // namespace

/// Room for as many points as each tile begins with: rows that grow point by point are copied over and over,
/// and leave their old places behind.
template <class Real>
void MovingSolver<Real>::reserve_points(const MovingStart& start) {
  const auto cols = static_cast<std::size_t>(geometry_.tiles_x);
  std::vector<std::int32_t> in_tile(static_cast<std::size_t>(geometry_.tiles_y) * cols, 0);
  for_each_point(start, scene_, [&](const StartPoint& point) {
    Real xi = 0, eta = 0;
    const TilePlace tile = place_of(point.x, point.y, xi, eta);
    ++in_tile[static_cast<std::size_t>(tile.row) * cols + static_cast<std::size_t>(tile.col)];
  });
  std::vector<std::int32_t> records(static_cast<std::size_t>(points_.blocks()));
  for (int row = 0; row < geometry_.tiles_y; ++row) {
    std::fill(records.begin(), records.end(), 0);
    for (int col = 0; col < geometry_.tiles_x; ++col) {
      std::int32_t& most = records[static_cast<std::size_t>(col / points_.lanes())];
      most = std::max(most, in_tile[static_cast<std::size_t>(row) * cols + static_cast<std::size_t>(col)]);
    }
    points_.reserve(row, records);
  }
}

template <class Real>
void MovingSolver<Real>::load_points(const MovingStart& start) {
  double fastest = 0;
  for_each_point(start, scene_, [&](const StartPoint& point) {
    points_.insert(loose_point(point));
    if (!point.ghost || point.kept > 0) ++live_[origin_of(scene_, point.id).label];
    fastest = std::max(fastest, point.vx * point.vx + point.vy * point.vy);
  });
  start_fastest_ = static_cast<Real>(fastest);
}

template <class Real>
PointView MovingSolver<Real>::view(const Slot& slot) const {
  const auto value = [&](int field) { return static_cast<double>(points_.value(slot, field)); };
  PointView point;
  point.id = points_.id(slot);
  const double col = slot.block * points_.lanes() + slot.lane + geometry_.tile_offset + value(moving::xi);
  const double row = slot.row + geometry_.tile_offset + value(moving::eta);
  point.x = geometry_.left + col * plan_.cell_size;
  point.y = geometry_.bottom + row * cell_height(clock_.displacement);
  point.vx = value(moving::vx);
  point.vy = value(moving::vy);
  point.mass = value(moving::mass);
  point.volume = value(moving::volume);
  point.stress = {value(moving::sxx), value(moving::syy), value(moving::sxy)};
  const moving::RecordLayout& layout = points_.layout();
  for (int i = 0; i < 4; ++i) {
    if (layout.affine >= 0) point.gradient[i] = value(layout.affine + i);
    if (layout.deformation >= 0) point.deformation[i] = value(layout.deformation + i);
  }
  return point;
}

template <class Real>
std::vector<PointView> MovingSolver<Real>::points() const {
  std::vector<PointView> views;
  for (int row = 0; row < points_.rows(); ++row)
    points_.for_each(row, [&](const Slot& slot) { views.push_back(view(slot)); });
  return views;
}

template <class Real>
void MovingSolver<Real>::kick(const Kick& change) {
  for (int row = 0; row < points_.rows(); ++row) {
    points_.for_each(row, [&](const Slot& slot) {
      const PointView point = view(slot);
      double vx = point.vx;
      double vy = point.vy;
      change(point, vx, vy);
      points_.value(slot, moving::vx) = static_cast<Real>(vx);
      points_.value(slot, moving::vy) = static_cast<Real>(vy);
      start_fastest_ = std::max(start_fastest_, static_cast<Real>(vx * vx + vy * vy));
    });
  }
}

template <class Real>
void MovingSolver<Real>::copy_maps(Result& result) const {
  maps_.copy_to(result);
  const float nowhere = std::numeric_limits<float>::quiet_NaN();
  result.end_x.setConstant(scene_.labels.rows(), scene_.labels.cols(), nowhere);
  result.end_y = result.end_x;
  if (plan_.moving.optional.deformation) result.deformation.fill(result.end_x);
  for (int row = 0; row < points_.rows(); ++row) {
    points_.for_each(row, [&](const Slot& slot) {
      const PointView point = view(slot);
      if (point.id >= static_cast<std::uint32_t>(scene_.labels.size())) return;
      result.end_x.data()[point.id] = static_cast<float>(point.x);
      result.end_y.data()[point.id] = static_cast<float>(point.y);
      for (std::size_t i = 0; i < 4 && plan_.moving.optional.deformation; ++i)
        result.deformation[i].data()[point.id] = static_cast<float>(point.deformation[i]);
    });
  }
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
