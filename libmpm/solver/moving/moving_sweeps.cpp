// The parts of a step of moving points, row by row.
#include <algorithm>

#include "libmpm/solver/moving/moving_solver.hpp"

namespace mpm {

template <class Real>
moving::NodeVectors<Real> MovingSolver<Real>::nodes(int tile_row, Field x, Field y) const {
  const std::size_t at = grid_.at(tile_row);
  return {(grid_.*x).data() + at, (grid_.*y).data() + at, grid_.stride};
}

template <class Real>
moving::TileRow<Real> MovingSolver<Real>::tiles(int row) {
  moving::TileRow<Real> tiles = points_.tile_row(row, Real(geometry_.bottom_of(row)));
  if (geometry_.before == 0) return tiles;  // linear shapes reach no node beyond a support
  tiles.folds = {.left = supports_.left.active ? 0 : -1,
                 .right = supports_.right.active ? geometry_.tiles_x - 1 : -1,
                 .lower = row == 0 && supports_.bottom.active,
                 .upper = row == geometry_.tiles_y - 1 && supports_.top.active};
  return tiles;
}

/// The sums of a row of tiles, which `sweep` is about to write; of a row without points they are zeros.
template <class Real>
void MovingSolver<Real>::scatter(moving::Scatter<Real> sweep, int row) {
  const bool moves_mass = sweep != sweeps_.scatter_force;
  const bool pushes = sweep != sweeps_.scatter_momentum;
  const bool is_empty = points_.is_empty(row);
  if (moves_mass) is_empty ? momentum_.clear(row) : momentum_.mark_filled(row);
  if (pushes) is_empty ? force_.clear(row) : force_.mark_filled(row);
  if (!is_empty) sweep(tiles(row), step_, momentum_.sums(row), force_.sums(row));
}

template <class Real>
void MovingSolver<Real>::sum_momentum(int node_row) {
  const std::size_t at = grid_.at(node_row);
  sweeps_.sum_momentum(momentum_.node_row(node_row), least_mass_, grid_.mass.data() + at,
                       grid_.vx.data() + at, grid_.vy.data() + at);
}

template <class Real>
void MovingSolver<Real>::sum_new_momentum(int node_row) {
  const std::size_t at = grid_.at(node_row);
  sweeps_.sum_new_momentum(new_momentum_.node_row(node_row), least_mass_, grid_.mass.data() + at,
                           grid_.strain_x.data() + at, grid_.strain_y.data() + at);
  hold_straining_velocity(node_row);
}

template <class Real>
void MovingSolver<Real>::integrate_momentum(int node_row) {
  const std::size_t at = grid_.at(node_row);
  const moving::Integration<Real> in{
      .forces = force_.node_row(node_row),
      .dt = step_.dt,
      .damping = static_cast<Real>(scene_.local_damping),
      .least_mass = least_mass_,
      .mass = grid_.mass.data() + at,
      .vx = grid_.vx.data() + at,
      .vy = grid_.vy.data() + at,
      .fresh_x = grid_.fresh_x.data() + at,
      .fresh_y = grid_.fresh_y.data() + at,
      .change_x = grid_.change_x.data() + at,
      .change_y = grid_.change_y.data() + at,
      .light_mass = light_mass_,
  };
  // The force at a platen is its reaction, not out of balance: damping would add to it.
  const bool at_platen = (node_row <= geometry_.before && supports_.bottom.active) ||
                         (node_row >= geometry_.cells_y + geometry_.before && supports_.top.active);
  row_damped_[static_cast<std::size_t>(node_row)] +=
      (at_platen ? integrate_undamped_ : sweeps_.integrate)(in);
  hold(node_row);
}

/// The velocity that the points brought strains them (USF).
template <class Real>
void MovingSolver<Real>::choose_brought_velocity(int node_row) {
  const auto copy = [&](const AlignedVector<Real>& from, AlignedVector<Real>& to) {
    const auto at = static_cast<std::ptrdiff_t>(grid_.at(node_row));
    std::copy_n(from.begin() + at, geometry_.nodes_x, to.begin() + at);
  };
  copy(grid_.vx, grid_.strain_x);
  copy(grid_.vy, grid_.strain_y);
  hold_straining_velocity(node_row);
}

/// That at the end of the step does, as far as the mass of a node bears it out (USL).
template <class Real>
void MovingSolver<Real>::choose_straining_velocity(int node_row) {
  for (int col = 0; col < geometry_.nodes_x; ++col) {
    const std::size_t at = grid_.at(node_row, col);
    const Real share = std::min(Real(1), grid_.mass[at] / light_mass_);
    grid_.strain_x[at] = grid_.vx[at] + share * (grid_.fresh_x[at] - grid_.vx[at]);
    grid_.strain_y[at] = grid_.vy[at] + share * (grid_.fresh_y[at] - grid_.vy[at]);
  }
  hold_straining_velocity(node_row);
}

template <class Real>
void MovingSolver<Real>::gather(moving::Gather<Real> sweep, Band& band, int row) {
  using Grid = MovingGrid<Real>;
  moving::Sums<Real> momentum{};
  if (sweep == sweeps_.gather_and_map_back) {
    if (points_.is_empty(row)) return new_momentum_.clear(row);
    new_momentum_.mark_filled(row);
    momentum = new_momentum_.sums(row);
  }
  if (points_.is_empty(row)) return;
  const auto change = slopes_from_straining_ ? nodes(row, &Grid::strain_x, &Grid::strain_y)
                                             : nodes(row, &Grid::change_x, &Grid::change_y);
  const Real fastest = sweep(tiles(row), step_, change, nodes(row, &Grid::fresh_x, &Grid::fresh_y), momentum);
  band.fastest = std::max(band.fastest, fastest);
}

/// Points follow the nodes, fail, and come into the band's list of movers when they left their tile.
template <class Real>
void MovingSolver<Real>::follow(moving::Follow<Real> sweep, Band& band, int row) {
  using Grid = MovingGrid<Real>;
  if (points_.is_empty(row)) return;
  const auto straining = nodes(row, &Grid::strain_x, &Grid::strain_y);
  const auto fresh = nodes(row, &Grid::fresh_x, &Grid::fresh_y);
  if (plan_.moving.optional.deformation && sweep != sweeps_.move)
    sweeps_.deform(tiles(row), step_, straining);
  const int became = sweep(tiles(row), step_, straining, fresh, band.flags.data());
  if ((became & moving::may_fail) != 0) fail_suspects(band, row);
  if ((became & moving::has_left) != 0) take_out_movers(band, row);
}

template <class Real>
void MovingSolver<Real>::take_out_movers(Band& band, int row) {
  for (int block = 0; block < points_.blocks(); ++block) {
    if ((band.flags[static_cast<std::size_t>(block)] & moving::has_left) == 0) continue;
    points_.for_each_of_block(row, block, [&](const Slot& slot) {
      const Real x = points_.value(slot, moving::xi);
      const Real y = points_.value(slot, moving::eta);
      if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) band.movers.push_back(points_.take_out(slot));
    });
    points_.trim(row, block);
  }
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
