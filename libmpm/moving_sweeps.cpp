// The parts of a step of moving points, row by row, and the order of the points after it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

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

/// Smooth platens leave the specimen free to slide; the node of the bottom nearest the middle of the picture
/// holds it.
template <class Real>
int MovingSolver<Real>::pinned_column(int node_row) {
  if (pinned_ >= 0) return pinned_;
  const int middle =
      static_cast<int>(std::lround(-geometry_.left / plan_.cell_size)) + plan_.cells_x / 2 + geometry_.before;
  const auto has_mass = [&](int col) {
    return col >= 0 && col < geometry_.nodes_x && grid_.mass[grid_.at(node_row, col)] > least_mass_;
  };
  for (int distance = 0; distance < geometry_.nodes_x; ++distance) {
    if (has_mass(middle - distance)) return pinned_ = middle - distance;
    if (has_mass(middle + distance)) return pinned_ = middle + distance;
  }
  return -1;
}

/// visit(column) for the nodes of a row at, and beyond, what stands at the edges.
template <class Real>
template <class Visit>
void MovingSolver<Real>::for_held_nodes(int node_row, Visit&& visit) {
  const int last_row = geometry_.cells_y + geometry_.before;
  const int last_col = geometry_.cells_x + geometry_.before;
  const bool at_bottom = node_row <= geometry_.before && supports_.bottom.active;
  const bool at_top = node_row >= last_row && supports_.top.active;
  if (at_bottom || at_top) {
    for (int col = 0; col < geometry_.nodes_x; ++col) visit(col);
    return;
  }
  if (supports_.left.active)
    for (int col = 0; col <= geometry_.before; ++col) visit(col);
  if (supports_.right.active)
    for (int col = last_col; col < geometry_.nodes_x; ++col) visit(col);
}

/// What stands at the edges gives the nodes on it its motion, and takes the reaction.
template <class Real>
void MovingSolver<Real>::hold(int node_row) {
  for_held_nodes(node_row, [&](int col) { hold_node(node_row, col); });
}

template <class Real>
void MovingSolver<Real>::hold_straining_velocity(int node_row) {
  for_held_nodes(node_row, [&](int col) { hold_straining(node_row, col); });
}

/// The forces of the step meet what stands at the edges.
template <class Real>
void MovingSolver<Real>::hold_node(int node_row, int col) {
  const std::size_t at = grid_.at(node_row, col);
  const std::uint8_t touched = std::exchange(contact_[at], std::uint8_t{0});
  if (!(grid_.mass[at] > least_mass_)) return;
  const int last_row = geometry_.cells_y + geometry_.before;
  const int last_col = geometry_.cells_x + geometry_.before;
  const bool at_top = node_row >= last_row;
  const bool at_right = col >= last_col;
  std::optional<Support::Held> x, y;
  if (at_top || node_row <= geometry_.before) {
    const Support& support = at_top ? supports_.top : supports_.bottom;
    y = support.caught(grid_.vy[at], grid_.change_y[at], at_top ? 1 : -1, (touched & touches_upright) != 0);
    if (y) contact_[at] |= touches_upright;
    if (y && support.rough) x = Support::Held{0, support.separates && touched == 0 ? grid_.vx[at] : 0};
  }
  if (at_right || col <= geometry_.before) {
    const Support& support = at_right ? supports_.right : supports_.left;
    const auto across =
        support.caught(grid_.vx[at], grid_.change_x[at], at_right ? 1 : -1, (touched & touches_across) != 0);
    if (across) {
      contact_[at] |= touches_across;
      x = across;
      if (support.rough) y = Support::Held{0, support.separates && touched == 0 ? grid_.vy[at] : 0};
    }
  }
  if (is_pinned(node_row, col)) x = Support::Held{0, 0};
  // What a point gets is the change for FLIP and the value for PIC and APIC.
  const double flip = scene_.motion.transfer == Transfer::apic ? 0 : scene_.motion.flip_ratio;
  const auto set = [&](const Support::Held& held, double brought, Real& fresh, Real& change) {
    const double push = change;
    fresh = static_cast<Real>(held.velocity);
    change = static_cast<Real>(held.velocity - held.before);
    return static_cast<double>(grid_.mass[at]) *
           (held.velocity - (flip * held.before + (1 - flip) * brought) - push);
  };
  if (x) (void)set(*x, grid_.vx[at], grid_.fresh_x[at], grid_.change_x[at]);
  if (!y) return;
  const double impulse = set(*y, grid_.vy[at], grid_.fresh_y[at], grid_.change_y[at]);
  Impulses& sums = row_impulses_[static_cast<std::size_t>(node_row)];
  if (node_row <= geometry_.before) sums.bottom += impulse;
  if (at_top) {
    sums.top += impulse;
    sums.work += impulse * supports_.top.velocity;
  }
}

/// The velocity that strains the points follows what the forces met: a node that a support still pushes must
/// not take its own way there, or the stress that pushes would stay, and its energy come from nothing.
template <class Real>
void MovingSolver<Real>::hold_straining(int node_row, int col) {
  const std::size_t at = grid_.at(node_row, col);
  if (!(grid_.mass[at] > least_mass_)) return;
  Real& x = grid_.strain_x[at];
  Real& y = grid_.strain_y[at];
  const auto touches = [&](const Support& support, std::uint8_t side) {
    return support.active && (!support.separates || (contact_[at] & side) != 0);
  };
  const bool at_top = node_row >= geometry_.cells_y + geometry_.before;
  const bool at_right = col >= geometry_.cells_x + geometry_.before;
  if (at_top || node_row <= geometry_.before) {
    const Support& support = at_top ? supports_.top : supports_.bottom;
    if (touches(support, touches_upright)) {
      y = static_cast<Real>(support.velocity);
      if (support.rough) x = 0;
    }
  }
  if (at_right || col <= geometry_.before) {
    const Support& support = at_right ? supports_.right : supports_.left;
    if (touches(support, touches_across)) {
      x = static_cast<Real>(support.velocity);
      if (support.rough) y = 0;
    }
  }
  if (is_pinned(node_row, col)) x = 0;
}

template <class Real>
bool MovingSolver<Real>::is_pinned(int node_row, int col) {
  return scene_.loading.direction != Direction::none && scene_.loading.platen == Platen::smooth &&
         !scene_.loading.separation && node_row <= geometry_.before && col == pinned_column(node_row);
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

/// Points that left their tile go to the one that they are in, in the order of the rows they came from,
/// whatever the number of bands.
template <class Real>
void MovingSolver<Real>::resort() {
  for (Band& band : bands_) {
    for (Loose& point : band.movers) {
      const auto step_over = [&](int& tile, Real& place) {
        const Real tiles = std::floor(place);
        if (!(std::abs(tiles) <= 1)) return false;
        tile += static_cast<int>(tiles);
        place -= tiles;
        if (place >= 1) place = std::nextafter(Real(1), Real(0));  // a place just below 0, rounded
        return true;
      };
      const TilePlace from = point.tile;
      if (!step_over(point.tile.col, point.values[moving::xi]) ||
          !step_over(point.tile.row, point.values[moving::eta])) {
        point.tile = from;
        stop("a point moves further than a cell in a step, " + name_of(point.id));
        continue;
      }
      const bool inside = point.tile.row >= 0 && point.tile.row < geometry_.tiles_y && point.tile.col >= 0 &&
                          point.tile.col < geometry_.tiles_x;
      if (inside)
        points_.insert(point);
      else
        leave(point);
    }
    band.movers.clear();
  }
}

template <class Real>
std::string MovingSolver<Real>::name_of(std::uint32_t id) const {
  const PointOrigin origin = origin_of(scene_, id);
  char text[96];
  if (origin.row < 0)
    std::snprintf(text, sizeof text, "extra point %zu", origin.extra);
  else
    std::snprintf(text, sizeof text, "the point of pixel (row %d, column %d)", origin.row, origin.col);
  return text;
}

template <class Real>
void MovingSolver<Real>::leave(const Loose& point) {
  const Motion& motion = scene_.motion;
  const bool sideways = point.tile.col < 0 || point.tile.col >= geometry_.tiles_x;
  const bool first = sideways ? point.tile.col < 0 : point.tile.row < 0;
  const bool platens = scene_.loading.direction != Direction::none;
  const Edge edge = sideways ? (first ? motion.left : motion.right)
                             : (platens ? Edge::symmetry
                                : first ? motion.bottom
                                        : motion.top);
  const char* name = sideways ? (first ? "left" : "right") : (first ? "bottom" : "top");
  if (edge != Edge::open) {
    stop(std::string("a point left the grid at the ") + name + " edge, " + name_of(point.id) +
         (edge == Edge::closed ? std::string("; make motion.margin larger, or motion.") + name + " = \"open\""
                               : std::string()));
    return;
  }
  ++left_;
  left_energy_ += energy_of(point);
  if (point.values[moving::shear] > 0) --live_[origin_of(scene_, point.id).label];
}

/// Kinetic and elastic energy of a point outside of the storage [J/m].
template <class Real>
double MovingSolver<Real>::energy_of(const Loose& point) const {
  MovingPoints<Real> alone(1, 1, sweeps_.lanes, points_.layout());
  Loose copy = point;
  copy.tile = {0, 0};
  alone.insert(copy);
  const moving::Energies energies = sweeps_.measure_energies(alone.tile_row(0, 0), step_);
  return energies.kinetic + energies.elastic;
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
