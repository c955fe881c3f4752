// What platens, walls and planes of symmetry do to the nodes of moving points.
#include <cmath>
#include <utility>

#include "libmpm/solver/moving/moving_solver.hpp"

namespace mpm {

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
  const auto value = [&](const AlignedVector<Real>& field) { return static_cast<double>(field[at]); };
  std::optional<Support::Held> x, y;
  if (at_top || node_row <= geometry_.before) {
    const Support& support = at_top ? supports_.top : supports_.bottom;
    y = support.caught(value(grid_.vy), value(grid_.change_y), at_top ? 1 : -1,
                       (touched & touches_upright) != 0);
    if (y) contact_[at] |= touches_upright;
    if (y && support.rough) x = Support::Held{0, support.separates && touched == 0 ? value(grid_.vx) : 0.0};
  }
  if (at_right || col <= geometry_.before) {
    const Support& support = at_right ? supports_.right : supports_.left;
    const auto across = support.caught(value(grid_.vx), value(grid_.change_x), at_right ? 1 : -1,
                                       (touched & touches_across) != 0);
    if (across) {
      contact_[at] |= touches_across;
      x = across;
      if (support.rough) y = Support::Held{0, support.separates && touched == 0 ? value(grid_.vy) : 0.0};
    }
  }
  if (is_pinned(node_row, col)) x = Support::Held{0, 0};
  // What a point gets is the change for FLIP and the value for PIC and APIC.
  const double flip = scene_.motion.transfer == Transfer::apic ? 0 : scene_.motion.flip_ratio;
  const auto set = [&](const Support::Held& held, double brought, Real& fresh, Real& change) {
    const auto push = static_cast<double>(change);
    fresh = static_cast<Real>(held.velocity);
    change = static_cast<Real>(held.velocity - held.before);
    return static_cast<double>(grid_.mass[at]) *
           (held.velocity - (flip * held.before + (1 - flip) * brought) - push);
  };
  if (x) (void)set(*x, value(grid_.vx), grid_.fresh_x[at], grid_.change_x[at]);
  if (!y) return;
  const double impulse = set(*y, value(grid_.vy), grid_.fresh_y[at], grid_.change_y[at]);
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

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
