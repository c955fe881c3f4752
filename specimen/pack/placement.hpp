/// Placement of ellipses one by one, each at the required gap from all others and from the walls; with a grid
/// of cells that finds neighbours at constant cost.
#pragma once

#include <algorithm>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/ellipse_gap.hpp"

namespace specimen {

/// Axis-parallel box [m].
struct Box {
  double left = 0, bottom = 0, right = 0, top = 0;
};
/// Smallest box around a body, enlarged by `margin` [m] on all sides.
[[nodiscard]] Box box_round(const Body& body, double margin);

/// Each box is entered in every cell that it touches. Cells as large as the smaller boxes keep the entries of
/// a large box and the boxes per cell few.
class SpatialGrid {
 public:
  /// @param cell  edge of a cell [m]; made larger where the specimen would need too many.
  SpatialGrid(double width, double height, double cell);

  void clear();
  /// Enter the box with the next number 0, 1, 2, ...
  void add(const Box& box);

  /// Call `visit(number)` once for every entered box that may meet `box`, until it returns false.
  /// @return false when a visit did.
  template <class Visit>
  bool visit_near(const Box& box, Visit visit) const {
    const Cells mine = cells_of(box);
    for (int row = mine.row0; row <= mine.row1; ++row) {
      for (int col = mine.col0; col <= mine.col1; ++col) {
        for (int e = first_[index(row, col)]; e >= 0; e = entries_[e].next) {
          const int number = entries_[e].number;
          const Cells& other = cells_[number];
          // Two boxes may share many cells; the pair counts in the first of them.
          if (row != std::max(mine.row0, other.row0) || col != std::max(mine.col0, other.col0)) continue;
          if (!visit(number)) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Cells {
    int row0, col0, row1, col1;
  };
  struct Entry {
    int number, next;
  };
  [[nodiscard]] Cells cells_of(const Box& box) const;
  [[nodiscard]] std::size_t index(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) + static_cast<std::size_t>(col);
  }

  double cell_;
  int rows_, cols_;
  std::vector<int> first_;      // of the list of each cell, -1: none
  std::vector<Entry> entries_;  // all lists
  std::vector<Cells> cells_;    // per box
};

/// The domain of a packing and the required gap.
struct Room {
  double width = 0;       ///< [m]
  double height = 0;      ///< [m]
  double gap = 0;         ///< smallest distance to each other and to the walls [m]
  bool periodic = false;  ///< no walls: periodic boundaries
};

/// Shifts to the periodic images [m]: zero, and in a periodic domain the eight around it. Complete for
/// ellipses whose long axis plus gap fits into the domain.
[[nodiscard]] std::vector<Point> repeats(const Room& room);

/// True when the ellipse keeps the gap to the four walls; always in a periodic domain.
[[nodiscard]] bool clear_of_walls(const Ellipse& e, const Room& room);

/// Edge of the cells of a grid for so many ellipses [m]: about one ellipse per cell.
[[nodiscard]] double cell_for(const Room& room, std::size_t count);

/// The ellipses placed so far; in a periodic domain their centres lie inside.
class Placement {
 public:
  /// @param count  expected number of ellipses; affects only the speed.
  Placement(const Room& room, std::size_t count);

  /// True when the ellipse keeps the gap to the walls and to all that are placed. Exact.
  [[nodiscard]] bool has_room_for(const Ellipse& e) const;
  void place(const Ellipse& e);

 private:
  [[nodiscard]] bool is_clear(const Body& body) const;

  Room room_;
  SpatialGrid grid_;
  std::vector<Body> bodies_;
  std::vector<Point> repeats_;
};

/// The ellipses that keep the gap to all previous ones, in the order of the list.
[[nodiscard]] std::vector<Ellipse> without_collisions(const std::vector<Ellipse>& ellipses, const Room& room);

}  // namespace specimen
