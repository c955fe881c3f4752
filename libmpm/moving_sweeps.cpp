// The parts of a step of moving points, row by row.
#include <algorithm>

#include "libmpm/moving_solver.hpp"

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

template <class Real>
void MovingSolver<Real>::scatter_mass_and_momentum(int row) {
  if (points_.is_empty(row)) return momentum_.clear(row);
  momentum_.mark_filled(row);
  sweeps_.scatter_momentum(tiles(row), step_, momentum_.sums(row));
}

template <class Real>
void MovingSolver<Real>::scatter_internal_force(int row) {
  if (points_.is_empty(row)) return force_.clear(row);
  force_.mark_filled(row);
  sweeps_.scatter_force(tiles(row), step_, force_.sums(row));
}

template <class Real>
void MovingSolver<Real>::sum_momentum(int node_row, Field vx, Field vy) {
  const std::size_t at = grid_.at(node_row);
  sweeps_.sum_momentum(momentum_.node_row(node_row), least_mass_, grid_.mass.data() + at,
                       (grid_.*vx).data() + at, (grid_.*vy).data() + at);
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
void MovingSolver<Real>::gather_motion(Band& band, int row) {
  using Grid = MovingGrid<Real>;
  if (points_.is_empty(row)) return;
  const auto change = slopes_from_straining_ ? nodes(row, &Grid::strain_x, &Grid::strain_y)
                                             : nodes(row, &Grid::change_x, &Grid::change_y);
  const Real fastest =
      sweeps_.gather_velocity(tiles(row), step_, change, nodes(row, &Grid::fresh_x, &Grid::fresh_y));
  band.fastest = std::max(band.fastest, fastest);
}

template <class Real>
void MovingSolver<Real>::update_stress_and_damage(Band& band, int row) {
  using Grid = MovingGrid<Real>;
  if (points_.is_empty(row)) return;
  const auto velocity = nodes(row, &Grid::strain_x, &Grid::strain_y);
  if (sweeps_.update_stress(tiles(row), step_, velocity, band.flags.data()) != 0) fail_suspects(band, row);
  if (plan_.moving.optional.deformation) sweeps_.deform(tiles(row), step_, velocity);
}

/// Points that left their tile come into the band's list of movers.
template <class Real>
void MovingSolver<Real>::move_points(Band& band, int row) {
  using Grid = MovingGrid<Real>;
  if (points_.is_empty(row)) return;
  if (sweeps_.move_points(tiles(row), step_, nodes(row, &Grid::fresh_x, &Grid::fresh_y), band.flags.data()) ==
      0)
    return;
  for (int block = 0; block < points_.blocks(); ++block) {
    if (band.flags[static_cast<std::size_t>(block)] == 0) continue;
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
