#include "libmpm/solver/quasi_static/pieces.hpp"

#include <numeric>

namespace mpm {

Pieces::Pieces(int cells_x, int cells_y, const std::function<bool(int, int)>& has_stiffness,
               const GridBoundary& boundary)
    : cells_x_(cells_x),
      parent_(static_cast<std::size_t>(cells_x + 1) * static_cast<std::size_t>(cells_y + 1) + 2) {
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  for (int row = 0; row < cells_y; ++row)
    for (int col = 0; col < cells_x; ++col) {
      if (!has_stiffness(row, col)) continue;
      for (int corner = 1; corner < 4; ++corner)
        join(node(row + corner / 2, col + corner % 2), node(row, col));
    }
  for (const HeldNode& held : boundary.held)
    join(node(held.row, held.col), held.load >= 0 ? above() : below());
  for (int col = 0; boundary.empty() && col <= cells_x; ++col) {
    join(node(0, col), below());
    join(node(cells_y, col), above());
  }
}

bool Pieces::is_held(int row, int col) const {
  for (int corner = 0; corner < 4; ++corner) {
    const std::size_t own = root(node(row + corner / 2, col + corner % 2));
    if (own != root(below()) && own != root(above())) return false;
  }
  return true;
}

std::size_t Pieces::root(std::size_t of) const {
  while (parent_[of] != of) of = parent_[of];
  return of;
}

std::size_t Pieces::shortened_root(std::size_t of) {
  while (parent_[of] != of) of = parent_[of] = parent_[parent_[of]];
  return of;
}

void Pieces::join(std::size_t a, std::size_t b) { parent_[shortened_root(a)] = shortened_root(b); }

}  // namespace mpm
