#include "specimen/pack/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "specimen/body/ellipse_gap.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/pack/placement.hpp"

namespace specimen {
namespace {

// Two bodies that may touch, and the direction across their gap when it was last looked at.
struct Neighbours {
  int first, second;
  Point shift;  // of the second, to where a periodic room repeats it
  Point u;
};

Body shifted(Body body, Point shift) {
  body.centre = body.centre + shift;
  return body;
}

class Relaxer {
 public:
  Relaxer(std::vector<Ellipse>& ellipses, const Room& room, Turning turning);
  Relaxation run();
  void bring_inside();

 private:
  void find_neighbours();
  void find_neighbours_of(int i, Point shift);
  void push_apart(Neighbours& pair);
  void push_from_walls(int i);
  void push_from_wall(int i, Point inward, double wall);
  // How far the body gives way to a unit impulse along n at a point of its boundary.
  double give(int i, Point n, Point at) const;
  void shove(int i, Point n, Point at, double impulse);
  bool sweep();
  [[nodiscard]] int most_sweeps() const;

  std::vector<Ellipse>& ellipses_;
  Room room_;
  std::vector<Point> repeats_;
  SpatialGrid grid_;
  std::vector<Body> bodies_;
  std::vector<double> ease_;      // of a shift: 1 / area, up to a factor
  std::vector<double> turnable_;  // ease of a turn: 1 / polar second moment of area, up to the same factor
  std::vector<Neighbours> pairs_;
  std::vector<Ellipse> when_found_;  // the ellipses when the neighbours were listed
  bool outdated_ = true;             // one has moved so far that a pair may be missing
  double clear_;                     // the gap to check for [m]
  double aim_;                       // the gap to push to [m]: a little more, so that the pushing ends
  double skin_;                      // how near a neighbour is beyond the gap [m]
  double unrest_ = 0;                // sum of the squares of what lacked, in the last sweep [m^2]
};

Relaxer::Relaxer(std::vector<Ellipse>& ellipses, const Room& room, Turning turning)
    : ellipses_(ellipses),
      room_(room),
      repeats_(repeats(room)),
      grid_(room.width, room.height, cell_for(room, ellipses.size())) {
  double thinnest = infinite;
  for (const Ellipse& e : ellipses) {
    bodies_.push_back(body_of(e));
    ease_.push_back(1 / (e.a * e.b));
    turnable_.push_back(turning == Turning::fixed ? 0 : 4 * ease_.back() / (e.a * e.a + e.b * e.b));
    thinnest = std::min(thinnest, e.b);
  }
  // The billionth covers the rounding of the angles when the result is brought to [0, pi).
  clear_ = room.gap + 1e-9 * thinnest;
  aim_ = room.gap + 0.05 * thinnest;
  skin_ = thinnest;
}

void Relaxer::bring_inside() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Ellipse& e = ellipses_[i];
    e.x -= room_.width * std::floor(e.x / room_.width);
    e.y -= room_.height * std::floor(e.y / room_.height);
    bodies_[i].centre = {e.x, e.y};
  }
}

void Relaxer::find_neighbours_of(int i, Point shift) {
  const double near = room_.gap + skin_;
  const Body body = shifted(bodies_[i], shift);
  grid_.visit_near(box_round(body, near / 2), [&](int j) {
    const Body& other = bodies_[j];
    const Point r = body.centre - other.centre;
    const double reach = body.a + other.a + near;
    if (dot(r, r) > reach * reach) return true;
    const Point start = dot(r, r) > 0 ? normalized(r) : Point{1, 0};
    const Point u = widest_direction_from(other, body, start);
    if (strip_between(other, body, u).width < near) pairs_.push_back({j, i, shift, u});
    return true;
  });
}

void Relaxer::find_neighbours() {
  grid_.clear();
  pairs_.clear();
  if (room_.periodic) bring_inside();
  when_found_ = ellipses_;
  outdated_ = false;
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    for (const Point shift : repeats_) find_neighbours_of(i, shift);
    grid_.add(box_round(bodies_[i], (room_.gap + skin_) / 2));
  }
}

double Relaxer::give(int i, Point n, Point at) const {
  const double lever = cross(at, n);
  return ease_[i] + lever * lever * turnable_[i];
}

void Relaxer::shove(int i, Point n, Point at, double impulse) {
  Ellipse& e = ellipses_[i];
  e.x += impulse * ease_[i] * n.x;
  e.y += impulse * ease_[i] * n.y;
  e.angle += impulse * turnable_[i] * cross(at, n);
  bodies_[i].centre = {e.x, e.y};
  bodies_[i].axis = rotation_by(e.angle);

  const Ellipse& old = when_found_[i];
  const double moved = length({e.x - old.x, e.y - old.y}) + e.a * std::abs(e.angle - old.angle);
  if (moved > skin_ / 2) outdated_ = true;
}

void Relaxer::push_apart(Neighbours& pair) {
  const Body first = bodies_[pair.first], second = shifted(bodies_[pair.second], pair.shift);
  // One strip that is wide enough proves the gap, whatever its direction.
  if (strip_between(first, second, pair.u).width >= clear_) return;
  pair.u = widest_direction_from(first, second, pair.u);
  const double width = strip_between(first, second, pair.u).width;
  if (width >= clear_) return;

  unrest_ += (clear_ - width) * (clear_ - width);
  const Point u = pair.u, back = -1.0 * u;
  const Point on_first = support_point(first, u), on_second = support_point(second, back);
  const double impulse =
      (aim_ - width) / (give(pair.first, back, on_first) + give(pair.second, u, on_second));
  shove(pair.first, back, on_first, impulse);
  shove(pair.second, u, on_second, impulse);
}

// `wall` is where the wall lies along its inward normal.
void Relaxer::push_from_wall(int i, Point inward, double wall) {
  const Body& body = bodies_[i];
  const double distance = dot(inward, body.centre) - wall;
  if (distance >= body.a + clear_) return;
  const Point nearest = support_point(body, -1.0 * inward);
  const double width = distance + dot(inward, nearest);
  if (width >= clear_) return;
  unrest_ += (clear_ - width) * (clear_ - width);
  shove(i, inward, nearest, (aim_ - width) / give(i, inward, nearest));
}

void Relaxer::push_from_walls(int i) {
  if (room_.periodic) return;
  push_from_wall(i, {1, 0}, 0);
  push_from_wall(i, {-1, 0}, -room_.width);
  push_from_wall(i, {0, 1}, 0);
  push_from_wall(i, {0, -1}, -room_.height);
}

// True when nothing had to be moved.
bool Relaxer::sweep() {
  if (outdated_) find_neighbours();
  unrest_ = 0;
  for (Neighbours& pair : pairs_) push_apart(pair);
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) push_from_walls(i);
  return unrest_ == 0;
}

// A second or two of work up to some thousand ellipses, linear beyond; what can be solved takes hundreds.
int Relaxer::most_sweeps() const {
  return static_cast<int>(std::clamp(4e6 / static_cast<double>(bodies_.size()), 1000.0, 10000.0));
}

Relaxation Relaxer::run() {
  constexpr int window = 250;
  constexpr double least_progress = 0.95;
  Relaxation result;
  double unrest_before = infinite;
  while (result.sweeps < most_sweeps()) {
    ++result.sweeps;
    if (sweep()) {
      result.solved = true;
      break;
    }
    if (result.sweeps % window == 0) {
      if (unrest_ > least_progress * unrest_before) break;
      unrest_before = unrest_;
    }
  }
  return result;
}

}  // namespace

Relaxation relax(std::vector<Ellipse>& ellipses, const Room& room, Turning turning) {
  if (ellipses.empty()) return {true, 0};
  Relaxer relaxer(ellipses, room, turning);
  Relaxation result = relaxer.run();
  if (room.periodic) relaxer.bring_inside();
  for (Ellipse& e : ellipses) e.angle -= std::numbers::pi * std::floor(e.angle / std::numbers::pi);
  if (result.solved) result.solved = without_collisions(ellipses, room).size() == ellipses.size();
  return result;
}

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
