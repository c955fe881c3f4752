#include "specimen/body/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_set>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

void check_segments(int segments) {
  constexpr int least = 3, most = 100'000;
  if (segments < least || segments > most) {
    throw Error("itz.segments", std::to_string(segments),
                "must be between " + std::to_string(least) + " and " + std::to_string(most),
                "the paper's rings have 36");
  }
}

std::vector<Point> cut_ellipse(const Ellipse& e, int segments) {
  const Rotation axis = rotation_by(e.angle);
  std::vector<Point> vertices;
  vertices.reserve(static_cast<std::size_t>(segments));
  for (int k = 0; k < segments; ++k) {
    const Rotation t = rotation_by(2 * std::numbers::pi * k / segments);
    const Point along = (e.a * t.cos) * Point{axis.cos, axis.sin};
    const Point across = (e.b * t.sin) * Point{-axis.sin, axis.cos};
    vertices.push_back(Point{e.x, e.y} + along + across);
  }
  return vertices;
}

double length_of(const std::vector<Point>& contour) {
  double sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    sum += length(contour[(i + 1) % contour.size()] - contour[i]);
  }
  return sum;
}

std::vector<Point> cut_contour(const std::vector<Point>& contour, int segments) {
  const double step = length_of(contour) / segments;
  std::vector<Point> vertices;
  vertices.reserve(static_cast<std::size_t>(segments));
  double walked = 0;  // along the contour, up to the corner i
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point from = contour[i], edge = contour[(i + 1) % contour.size()] - from;
    const double edge_length = length(edge);
    for (;;) {
      const double along = step * static_cast<double>(vertices.size()) - walked;
      if (along >= edge_length || static_cast<int>(vertices.size()) == segments) break;
      vertices.push_back(from + (along / edge_length) * edge);
    }
    walked += edge_length;
  }
  // Rounding may end the walk a hair before the last corner; a contour without length has them all in one.
  while (static_cast<int>(vertices.size()) < segments) vertices.push_back(contour.front());
  return vertices;
}

// The part of a row of pixels that lies within `thickness` of a segment. The region is convex, so the row
// cuts it in one interval, which ends on one of the two caps or on one of the two long sides.
struct Interval {
  double left = infinite, right = -infinite;
  void include(double x) {
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

void include_cap(Interval& interval, Point end, double y, double thickness) {
  const double dy = y - end.y, dx2 = thickness * thickness - dy * dy;
  if (dx2 < 0) return;
  interval.include(end.x - std::sqrt(dx2));
  interval.include(end.x + std::sqrt(dx2));
}

void include_side(Interval& interval, Point from, Point to, double y) {
  const double t = (y - from.y) / (to.y - from.y);
  if (t >= 0 && t <= 1) interval.include(from.x + t * (to.x - from.x));  // false for a level side
}

Interval row_near_segment(Point from, Point to, double y, double thickness) {
  Interval interval;
  include_cap(interval, from, y, thickness);
  include_cap(interval, to, y, thickness);
  const double size = length(to - from);
  if (size > 0) {
    const Point aside = (thickness / size) * turned_left(to - from);
    include_side(interval, from + aside, to + aside, y);
    include_side(interval, from - aside, to - aside, y);
  }
  return interval;
}

// First and last index 0 ... count - 1 of pixels whose centres lie between two positions.
struct Span {
  int first, last;
};
Span centres_between(double low, double high, double pixel_size, int count) {
  constexpr double slack = 1e-9;  // [pixels]: a centre right at the limit belongs to it
  const auto within = [count](double at) { return std::clamp(at, -1.0, static_cast<double>(count)); };
  return {std::max(0, static_cast<int>(within(std::ceil(low / pixel_size - 0.5 - slack)))),
          std::min(count - 1, static_cast<int>(within(std::floor(high / pixel_size - 0.5 + slack))))};
}

void turn_mortar_to_itz(std::uint8_t& label) {
  if (label == phase::mortar) label = phase::itz;
}

void draw_segment(LabelledMask& mask, Point from, Point to, double thickness) {
  const int rows = mask.labels.rows;
  const Span up = centres_between(std::min(from.y, to.y) - thickness, std::max(from.y, to.y) + thickness,
                                  mask.pixel_size, rows);
  for (int k = up.first; k <= up.last; ++k) {
    const Interval x = row_near_segment(from, to, (k + 0.5) * mask.pixel_size, thickness);
    if (x.left > x.right) continue;
    const Span across = centres_between(x.left, x.right, mask.pixel_size, mask.labels.cols);
    for (int col = across.first; col <= across.last; ++col)
      turn_mortar_to_itz(mask.labels(rows - 1 - k, col));
  }
}

// Pixels of each inclusion that has a ring; 0 for the others.
std::vector<std::int64_t> areas_of(const Raster<std::int32_t>& instances,
                                   const std::unordered_set<std::int32_t>& ids) {
  std::vector<std::int64_t> areas;
  for (const std::int32_t id : instances.data) {
    if (id <= 0) continue;
    const auto i = static_cast<std::size_t>(id);
    if (i >= areas.size()) areas.resize(i + 1, 0);
    ++areas[i];
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (!ids.contains(static_cast<std::int32_t>(i))) areas[i] = 0;
  return areas;
}

// Mortar pixels that share an edge with one of the inclusions; where two inclusions share one, the pixel of
// the larger.
void close_rings(LabelledMask& mask, const Raster<std::int32_t>& instances,
                 const std::unordered_set<std::int32_t>& ids) {
  const std::vector<std::int64_t> areas = areas_of(instances, ids);
  const auto area_at = [&](int row, int col) -> std::int64_t {
    if (!instances.contains(row, col) || instances(row, col) <= 0) return 0;
    return areas[static_cast<std::size_t>(instances(row, col))];
  };
  const auto listed = [&](int row, int col) { return area_at(row, col) > 0; };
  const auto gives_way = [&](int row, int col, int to_row, int to_col) {
    const std::int64_t mine = area_at(row, col), theirs = area_at(to_row, to_col);
    if (theirs == 0 || instances(row, col) == instances(to_row, to_col)) return false;
    return mine > theirs || (mine == theirs && instances(row, col) > instances(to_row, to_col));
  };
  for (int row = 0; row < instances.rows; ++row) {
    for (int col = 0; col < instances.cols; ++col) {
      if (mask.labels(row, col) == phase::aggregate && listed(row, col) &&
          (gives_way(row, col, row - 1, col) || gives_way(row, col, row + 1, col) ||
           gives_way(row, col, row, col - 1) || gives_way(row, col, row, col + 1)))
        mask.labels(row, col) = phase::itz;
      if (mask.labels(row, col) != phase::mortar) continue;
      if (listed(row - 1, col) || listed(row + 1, col) || listed(row, col - 1) || listed(row, col + 1))
        mask.labels(row, col) = phase::itz;
    }
  }
}

}  // namespace

std::vector<Ring> make_rings(const Inclusion& inclusion, int segments) {
  constexpr int usual = 36, points_a_segment = 3;
  if (segments != 0) check_segments(segments);
  if (inclusion.contour.empty())
    return {{inclusion.id, cut_ellipse(inclusion.ellipse, segments == 0 ? usual : segments)}};
  std::vector<Ring> rings;
  for (const std::vector<Point>& loop : loops_of(inclusion.contour)) {
    const int steps = static_cast<int>((loop.size() + points_a_segment - 1) / points_a_segment);
    rings.push_back({inclusion.id, cut_contour(loop, segments == 0 ? std::max(usual, steps) : segments)});
  }
  return rings;
}

void draw_rings(LabelledMask& mask, const Raster<std::int32_t>& instances, const std::vector<Ring>& rings,
                double thickness) {
  if (!(thickness > 0) || !std::isfinite(thickness))
    throw Error("itz.thickness", millimetres(thickness), "must be > 0");
  if (instances.rows != mask.labels.rows || instances.cols != mask.labels.cols) {
    const auto shape = [](const auto& raster) {
      return std::to_string(raster.cols) + " x " + std::to_string(raster.rows);
    };
    throw Error("instances", shape(instances) + " pixels",
                "must have the shape of the mask, " + shape(mask.labels) + " pixels");
  }
  std::unordered_set<std::int32_t> ids;
  for (const Ring& ring : rings) {
    ids.insert(ring.inclusion);
    for (std::size_t i = 0; i < ring.vertices.size(); ++i)
      draw_segment(mask, ring.vertices[i], ring.vertices[(i + 1) % ring.vertices.size()], thickness);
  }
  close_rings(mask, instances, ids);
}

void draw_ring(LabelledMask& mask, const Raster<std::int32_t>& instances, const Ring& ring,
               double thickness) {
  draw_rings(mask, instances, {ring}, thickness);
}

}  // namespace specimen
