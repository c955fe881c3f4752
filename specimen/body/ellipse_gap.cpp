#include "specimen/body/ellipse_gap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

// How far the body reaches along u, and its radius of curvature there.
struct Reach {
  double h, radius;
  Point point;  // of support, from the centre
};

// In the axes of the ellipse and not by Q, whose entries would cancel for a thin one.
Reach reach(const Body& body, Point u) {
  const Point axis{body.axis.cos, body.axis.sin};
  const double along = body.a * dot(axis, u), across = body.b * cross(axis, u);
  const double h = std::sqrt(along * along + across * across);
  const double ab_h = body.a * body.b / h;
  return {h, ab_h * ab_h / h, (body.a * along / h) * axis + (body.b * across / h) * turned_left(axis)};
}

// u turned by about `step` [rad]; exact to second order, and never by 90 degrees or more.
Point turned(Point u, double step) { return normalized(u + step * turned_left(u)); }

// The directions from `from` counter-clockwise to `to`, at most half a turn.
struct Arc {
  Point from, to;
  [[nodiscard]] bool holds(Point u) const { return cross(from, u) >= 0 && cross(u, to) >= 0; }
  [[nodiscard]] Point middle() const {
    const Point sum = from + to;
    return length(sum) > 0.01 ? normalized(sum) : turned_left(from);
  }
};

// Unit vectors v with p.v >= gap.
Arc directions_that_reach(Point p, double gap) {
  const double size = length(p);
  const Point u = (1 / size) * p;
  const double cos = gap / size, sin = std::sqrt(std::max(0.0, 1 - cos * cos));
  return {cos * u - sin * turned_left(u), cos * u + sin * turned_left(u)};
}

// Cut `arc` down to its part within `other`; false when nothing is left.
bool narrow(Arc& arc, const Arc& other) {
  const bool from_inside = arc.holds(other.from), to_inside = arc.holds(other.to);
  if (!from_inside && !to_inside) return other.holds(arc.from) && other.holds(arc.to);
  if (from_inside) arc.from = other.from;
  if (to_inside && cross(arc.from, other.to) >= 0) arc.to = other.to;
  return true;
}

}  // namespace

Body body_of(const Ellipse& e) { return {{e.x, e.y}, e.a, e.b, rotation_by(e.angle)}; }

Point support_point(const Body& body, Point u) { return reach(body, u).point; }

Strip strip_between(const Body& first, const Body& second, Point u) {
  const Point r = second.centre - first.centre;
  const Reach one = reach(first, u), two = reach(second, u);
  const double width = dot(u, r) - one.h - two.h;
  return {width, cross(u, r - one.point - two.point), width + one.radius + two.radius};
}

GapAnswer test_gap(const Body& first, const Body& second, double gap) {
  const Point r = second.centre - first.centre;
  const double distance = length(r);
  if (distance >= first.a + second.a + gap) return {true, 0};
  if (distance < first.b + second.b + gap) return {false, 0};

  // Every evaluation leaves an arc of directions that could still be wide enough, and the next one is taken
  // from it. Newton's step decides nearly always; alternating with bisection makes the arc vanish for
  // certain, in 53 halvings at most.
  constexpr int newton_steps = 6, most_steps = 128;
  Point u = (1 / distance) * r;
  Arc candidates{};
  for (int n = 1; n <= most_steps; ++n) {
    const Strip strip = strip_between(first, second, u);
    if (strip.width >= gap) return {true, n};
    if (strip.width * strip.width + strip.slope * strip.slope < gap * gap) return {false, n};
    const Point p = strip.width * u + strip.slope * turned_left(u);
    const Arc reached = directions_that_reach(p, gap);
    if (n == 1)
      candidates = reached;
    else if (!narrow(candidates, reached))
      return {false, n};
    const bool may_step = strip.curvature > 0 && (n <= newton_steps || n % 2 == 0);
    if (may_step) u = turned(u, strip.slope / strip.curvature);
    if (!may_step || !candidates.holds(u)) u = candidates.middle();
  }
  return {false, most_steps};  // the gap equals `gap` to the last bit: the safe side
}

Point widest_direction_from(const Body& first, const Body& second, Point u) {
  constexpr int most_steps = 12;
  constexpr double accuracy = 1e-7;  // [rad]; the width is then exact to 1e-14 of the radii of curvature
  for (int n = 0; n < most_steps; ++n) {
    const Strip strip = strip_between(first, second, u);
    // Uphill where the width is not concave: a turn by up to 45 degrees.
    const double scale = strip.curvature > 0 ? strip.curvature : std::abs(strip.slope) + first.b + second.b;
    const double step = std::clamp(strip.slope / scale, -1.0, 1.0);
    u = turned(u, step);
    if (std::abs(step) < accuracy) break;
  }
  return u;
}

namespace {

// Normals of the body at equal steps of its parameter: they crowd where its support function bends most.
void add_normals(const Body& body, int count, std::vector<Point>& directions) {
  const Point axis{body.axis.cos, body.axis.sin};
  for (int k = 0; k < count; ++k) {
    const Rotation t = rotation_by(2 * std::numbers::pi * k / count);
    directions.push_back(normalized((body.b * t.cos) * axis + (body.a * t.sin) * turned_left(axis)));
  }
}

// Directions round the whole turn, so close that hardly two maxima of the strip's width lie between two.
std::vector<Point> probe_directions(const Body& first, const Body& second) {
  constexpr int even = 32, normals = 32;
  std::vector<Point> directions;
  directions.reserve(even + 2 * normals);
  add_normals({{}, 1, 1, {}}, even, directions);
  add_normals(first, normals, directions);
  add_normals(second, normals, directions);
  const auto upper = [](Point u) { return u.y > 0 || (u.y == 0 && u.x > 0); };
  std::sort(directions.begin(), directions.end(),
            [&](Point u, Point v) { return upper(u) != upper(v) ? upper(u) : cross(u, v) > 0; });
  return directions;
}

// Largest width between two directions of which the width rises at the first and falls at the second.
double widest_between(const Body& first, const Body& second, Arc arc) {
  double best = -infinite;
  for (int n = 0; n < 64; ++n) {
    const Point u = arc.middle();
    const Strip strip = strip_between(first, second, u);
    best = std::max(best, strip.width);
    (strip.slope > 0 ? arc.from : arc.to) = u;
    if (length(arc.to - arc.from) < 1e-12) break;
  }
  return best;
}

}  // namespace

double exact_gap(const Body& first, const Body& second) {
  const std::vector<Point> directions = probe_directions(first, second);
  double best = -infinite;
  Point last = directions.back();
  Strip before = strip_between(first, second, last);
  for (const Point& u : directions) {
    const Strip here = strip_between(first, second, u);
    best = std::max(best, here.width);
    if (before.slope > 0 && here.slope < 0) best = std::max(best, widest_between(first, second, {last, u}));
    last = u;
    before = here;
  }
  return best;
}

}  // namespace specimen
