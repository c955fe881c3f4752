#include "specimen/pack/settle.hpp"

#include <numbers>

namespace specimen {
namespace {

// Random direction and centre; false when the ellipse does not fit between the walls at that direction.
bool drop(Ellipse& e, const Room& room, Turning turning, Random& random) {
  if (turning == Turning::free) e.angle = random.uniform(0, std::numbers::pi);
  const double u = random.uniform(), v = random.uniform();
  if (room.periodic) {
    e.x = u * room.width;
    e.y = v * room.height;
    return true;
  }
  const Point half = half_extent(e);
  const double x_room = room.width - 2 * (half.x + room.gap);
  const double y_room = room.height - 2 * (half.y + room.gap);
  e.x = half.x + room.gap + u * x_room;
  e.y = half.y + room.gap + v * y_room;
  return x_room >= 0 && y_room >= 0;
}

bool drop_between_walls(Ellipse& e, const Room& room, Turning turning, Random& random) {
  for (int tries = 0; tries < 1000; ++tries) {
    if (drop(e, room, turning, random)) return true;
  }
  return false;
}

// Those that find no place stay where they were dropped last.
struct Placed {
  int homeless = 0;                      // number of these
  std::optional<std::size_t> too_large;  // fits between the walls at no direction
};

Placed place(std::vector<Ellipse>& ellipses, const Room& room, Turning turning, Random& random) {
  constexpr int most_tries = 500;
  Placement placement(room, ellipses.size());
  Placed placed;
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    bool found = false;
    for (int tries = 0; tries < most_tries && !found; ++tries) {
      if (!drop_between_walls(ellipses[i], room, turning, random)) return {0, i};
      found = placement.has_room_for(ellipses[i]);
    }
    if (found)
      placement.place(ellipses[i]);
    else
      ++placed.homeless;
  }
  return placed;
}

}  // namespace

Settlement settle(std::vector<Ellipse>& ellipses, const Room& room, Turning turning, Random& random) {
  const Placed placed = place(ellipses, room, turning, random);
  if (placed.too_large) return {false, false, placed.too_large};
  if (placed.homeless == 0) return {true, false, {}};
  return {relax(ellipses, room, turning).solved, true, {}};
}

}  // namespace specimen
