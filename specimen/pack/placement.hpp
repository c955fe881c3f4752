/// Ellipses placed one by one in a room, each at the required gap from all others and from the walls.
#pragma once

#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/pack/spatial_grid.hpp"

namespace specimen {

/// Where ellipses lie and how far apart they must be.
struct Room {
  double width = 0;       ///< [m]
  double height = 0;      ///< [m]
  double gap = 0;         ///< least distance to each other and to the walls [m]
  bool periodic = false;  ///< no walls: what leaves the room on one side comes in on the other
};

/// Shifts that bring ellipses of the room to where it repeats itself [m]: nought, and in a periodic room the
/// eight round it. Complete for ellipses whose long axis and gap fit into the room.
[[nodiscard]] std::vector<Point> repeats(const Room& room);

/// True when the ellipse keeps the gap to the four walls; always in a periodic room.
[[nodiscard]] bool clear_of_walls(const Ellipse& e, const Room& room);

/// Edge of the cells of a grid for so many ellipses [m]: about one of them to a cell.
[[nodiscard]] double cell_for(const Room& room, std::size_t count);

/// The ellipses placed so far; in a periodic room their centres lie inside.
class Placement {
 public:
  /// @param count  of ellipses to expect; only the speed depends on it.
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

/// The ellipses that keep every gap to those before them, in the order of the list.
[[nodiscard]] std::vector<Ellipse> without_collisions(const std::vector<Ellipse>& ellipses, const Room& room);

}  // namespace specimen
