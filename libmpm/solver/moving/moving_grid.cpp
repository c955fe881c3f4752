#include "libmpm/solver/moving/moving_grid.hpp"

#include <algorithm>

#include "libmpm/solver/grid.hpp"

namespace mpm {

MovingGeometry moving_geometry(const Scene& scene, const Plan& plan) {
  const bool linear = scene.motion.shape == Shape::linear;
  const MovingPlan& moving = plan.moving;
  MovingGeometry geometry;
  geometry.cells_x = plan.cells_x + moving.margin_left + moving.margin_right;
  geometry.cells_y = plan.cells_y + moving.margin_bottom + moving.margin_top;
  geometry.reach = linear ? 2 : 3;
  geometry.before = linear ? 0 : 1;
  geometry.tiles_x = geometry.cells_x + geometry.before;
  geometry.tiles_y = geometry.cells_y + geometry.before;
  geometry.nodes_x = geometry.tiles_x + geometry.reach - 1;
  geometry.nodes_y = geometry.tiles_y + geometry.reach - 1;
  geometry.tile_offset = linear ? 0 : -0.5;
  geometry.left = -moving.margin_left * plan.cell_size;
  geometry.bottom = -moving.margin_bottom * plan.cell_size;
  return geometry;
}

template <class Real>
MovingGrid<Real> make_moving_grid(const MovingGeometry& geometry) {
  MovingGrid<Real> grid;
  // A vector may begin at the last tile and reach over its nodes.
  grid.stride = padded(geometry.nodes_x) + 2 * kernels::lane_cells;
  const auto size = static_cast<std::size_t>(geometry.nodes_y * grid.stride);
  for (auto* field : {&grid.mass, &grid.vx, &grid.vy, &grid.fresh_x, &grid.fresh_y, &grid.change_x,
                      &grid.change_y, &grid.strain_x, &grid.strain_y})
    field->assign(size, Real(0));
  return grid;
}

namespace {

/// Places of the rows of tiles. A row of nodes needs `reach` rows at once. The first and the last rows of a
/// band are needed again, for the nodes that it shares with the bands below and above: reach - 1 of them, and
/// below as many more where the rows in between wait for those.
std::vector<std::size_t> places_in_turn(const std::vector<int>& band_ends, int reach) {
  std::vector<std::size_t> places;
  std::size_t next = 0;
  int begin = 0;
  for (const int end : band_ends) {
    const std::size_t turn = next;
    const int kept_above = reach - 1;
    const int kept_below = 2 * kept_above;
    const bool takes_turns = end - begin > kept_below + kept_above + reach;
    if (takes_turns) next += static_cast<std::size_t>(reach);
    for (int row = begin; row < end; ++row) {
      const bool in_turn = takes_turns && row >= begin + kept_below && row < end - kept_above;
      places.push_back(in_turn ? turn + static_cast<std::size_t>(row % reach) : next++);
    }
    begin = end;
  }
  return places;
}

/// An odd number of cache lines, so that the planes of a row do not all fall on the same sets of the cache.
template <class Real>
std::ptrdiff_t plane_length(int tiles) {
  constexpr std::ptrdiff_t line = 64 / sizeof(Real);
  const std::ptrdiff_t lines = (padded(tiles) + 3 * moving::padding + line - 1) / line;
  return (lines | 1) * line;
}

}  // namespace

template <class Real>
TileSums<Real>::TileSums(const MovingGeometry& geometry, int quantities, const std::vector<int>& band_ends)
    : tiles_y_(geometry.tiles_y),
      reach_(geometry.reach),
      nodes_(padded(geometry.nodes_x)),
      length_(plane_length<Real>(geometry.tiles_x)),
      row_size_(static_cast<std::size_t>(reach_ * reach_ * quantities * length_)),
      places_(places_in_turn(band_ends, reach_)) {
  const std::size_t count = *std::max_element(places_.begin(), places_.end()) + 1;
  values_.assign(count * row_size_, Real(0));
  is_zero_.assign(count, 1);
  zeros_.assign(row_size_, Real(0));
}

template <class Real>
const Real* TileSums<Real>::row(int tile_row) const {
  const bool inside = tile_row >= 0 && tile_row < tiles_y_;
  return (inside ? values_.data() + place(tile_row) * row_size_ : zeros_.data()) + moving::padding;
}

template <class Real>
moving::Sums<Real> TileSums<Real>::sums(int tile_row) {
  return {values_.data() + place(tile_row) * row_size_ + moving::padding, length_};
}

template <class Real>
moving::NodeRow<Real> TileSums<Real>::node_row(int node_row) const {
  return {{row(node_row), row(node_row - 1), row(reach_ > 2 ? node_row - 2 : -1)}, length_, nodes_};
}

template <class Real>
void TileSums<Real>::clear(int tile_row) {
  std::uint8_t& is_zero = is_zero_[place(tile_row)];
  if (is_zero != 0) return;
  std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>(place(tile_row) * row_size_), row_size_, Real(0));
  is_zero = 1;
}

template struct MovingGrid<float>;
template struct MovingGrid<double>;
template MovingGrid<float> make_moving_grid(const MovingGeometry&);
template MovingGrid<double> make_moving_grid(const MovingGeometry&);
template class TileSums<float>;
template class TileSums<double>;

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
