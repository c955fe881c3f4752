/// How the nodes of a grid lie between those of one that is coarser, along one axis.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mpm {

/// A coarse cell holds two cells of the finer grid, the last one three where their number is odd. So any
/// number of cells can be made coarser without cells of nothing beyond the edge, and no cell is ever longer
/// than twice the others.
class CoarseAxis {
 public:
  CoarseAxis() = default;
  /// The finest grid, of cells of length 1.
  explicit CoarseAxis(int cells) {
    for (int node = 0; node <= cells; ++node) places_.push_back(node);
  }
  /// The next coarser grid.   @pre the finer one has at least 2 cells.
  explicit CoarseAxis(const CoarseAxis& finer, int cells) : fine_cells_(finer.cells()) {
    for (int node = 0; node < cells; ++node)
      places_.push_back(finer.places_[static_cast<std::size_t>(2 * node)]);
    places_.push_back(finer.places_.back());
    for (int node = 0; node <= fine_cells_; ++node)
      weights_.push_back(place_in(left_of(node), finer.places_[static_cast<std::size_t>(node)]));
  }

  [[nodiscard]] int cells() const { return static_cast<int>(places_.size()) - 1; }
  [[nodiscard]] int fine_cells() const { return fine_cells_; }
  /// Cells of the finer grid in a cell begin with cell 2 c.
  [[nodiscard]] int children(int cell) const { return cell + 1 == cells() ? fine_cells_ - 2 * cell : 2; }
  /// In cells of the finest grid.
  [[nodiscard]] int length(int cell) const {
    const auto c = static_cast<std::size_t>(cell);
    return static_cast<int>(places_[c + 1] - places_[c]);
  }
  /// Whether a cell holds two cells of the same length.
  [[nodiscard]] bool halves(int cell) const { return children(cell) == 2 && weight(2 * cell + 1) == 0.5; }
  /// The cell that a node of the finer grid lies in; at the node between two cells the right one.
  [[nodiscard]] int left_of(int fine_node) const { return std::min(fine_node / 2, cells() - 1); }
  /// Weight of the right node of that cell in the fine one [-].
  [[nodiscard]] double weight(int fine_node) const { return weights_[static_cast<std::size_t>(fine_node)]; }
  /// The same for a node of a given cell, which may be its right end.
  [[nodiscard]] double weight_in(int cell, int fine_node) const {
    return left_of(fine_node) == cell ? weight(fine_node) : 1;
  }

 private:
  [[nodiscard]] double place_in(int cell, double place) const {
    const auto c = static_cast<std::size_t>(cell);
    return (place - places_[c]) / (places_[c + 1] - places_[c]);
  }

  int fine_cells_ = 0;
  std::vector<double> places_;   ///< of the nodes, in cells of the finest grid
  std::vector<double> weights_;  ///< by node of the finer grid
};

}  // namespace mpm
