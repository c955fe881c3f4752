/// What hangs together with the platens: cells with stiffness, through the nodes that they share.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "libmpm/solver/boundary.hpp"

namespace mpm {

class Pieces {
 public:
  /// @param has_stiffness  whether a cell (row, column) holds its nodes together.
  /// @param boundary  what holds the specimen is the lower platen, what moves it is the upper one; empty =
  /// both are platens.
  Pieces(int cells_x, int cells_y, const std::function<bool(int, int)>& has_stiffness,
         const GridBoundary& boundary = {});

  /// Whether every node of a cell has a way to a platen.
  [[nodiscard]] bool is_held(int row, int col) const;
  /// Whether there is a way from one platen to the other.
  [[nodiscard]] bool joins_platens() const { return root(below()) == root(above()); }
  /// Whether a node has a way to the upper platen, or to the lower one; row 0 is the lowest of cells_y + 1.
  [[nodiscard]] bool is_above(int row, int col) const { return root(node(row, col)) == root(above()); }
  [[nodiscard]] bool is_below(int row, int col) const { return root(node(row, col)) == root(below()); }

 private:
  [[nodiscard]] std::size_t node(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_x_ + 1) +
           static_cast<std::size_t>(col);
  }
  [[nodiscard]] std::size_t below() const { return parent_.size() - 2; }
  [[nodiscard]] std::size_t above() const { return parent_.size() - 1; }
  [[nodiscard]] std::size_t root(std::size_t of) const;
  [[nodiscard]] std::size_t shortened_root(std::size_t of);
  void join(std::size_t a, std::size_t b);

  int cells_x_;
  std::vector<std::size_t> parent_;  ///< of each node, then of both platens; a root is its own
};

}  // namespace mpm
