#include "specimen/pack/placement.hpp"

#include <algorithm>
#include <cmath>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

double cell_that_fits(double width, double height, double cell) {
  constexpr double most_cells = 4e6;
  return std::max(cell, std::sqrt(width * height / most_cells));
}

}  // namespace

Box box_round(const Body& body, double margin) {
  const double c = body.axis.cos, s = body.axis.sin, aa = body.a * body.a, bb = body.b * body.b;
  const double x = std::sqrt(aa * c * c + bb * s * s) + margin;
  const double y = std::sqrt(aa * s * s + bb * c * c) + margin;
  return {body.centre.x - x, body.centre.y - y, body.centre.x + x, body.centre.y + y};
}

SpatialGrid::SpatialGrid(double width, double height, double cell)
    : cell_(cell_that_fits(width, height, cell)),
      rows_(static_cast<int>(std::ceil(height / cell_))),
      cols_(static_cast<int>(std::ceil(width / cell_))),
      first_(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_), -1) {}

void SpatialGrid::clear() {
  std::fill(first_.begin(), first_.end(), -1);
  entries_.clear();
  cells_.clear();
}

SpatialGrid::Cells SpatialGrid::cells_of(const Box& box) const {
  const auto cell = [this](double at, int count) {
    return static_cast<int>(std::clamp(at / cell_, 0.0, count - 1.0));
  };
  return {cell(box.bottom, rows_), cell(box.left, cols_), cell(box.top, rows_), cell(box.right, cols_)};
}

void SpatialGrid::add(const Box& box) {
  const int number = static_cast<int>(cells_.size());
  const Cells cells = cells_of(box);
  cells_.push_back(cells);
  for (int row = cells.row0; row <= cells.row1; ++row) {
    for (int col = cells.col0; col <= cells.col1; ++col) {
      int& first = first_[index(row, col)];
      entries_.push_back({number, first});
      first = static_cast<int>(entries_.size()) - 1;
    }
  }
}

std::vector<Point> repeats(const Room& room) {
  std::vector<Point> shifts{{0, 0}};
  if (!room.periodic) return shifts;
  for (const int across : {-1, 0, 1})
    for (const int up : {-1, 0, 1})
      if (across != 0 || up != 0) shifts.push_back({across * room.width, up * room.height});
  return shifts;
}

bool clear_of_walls(const Ellipse& e, const Room& room) {
  if (room.periodic) return true;
  const Point half = half_extent(e);
  return e.x - half.x >= room.gap && room.width - (e.x + half.x) >= room.gap && e.y - half.y >= room.gap &&
         room.height - (e.y + half.y) >= room.gap;
}

double cell_for(const Room& room, std::size_t count) {
  return std::sqrt(room.width * room.height / static_cast<double>(count + 1));
}

Placement::Placement(const Room& room, std::size_t count)
    : room_(room), grid_(room.width, room.height, cell_for(room, count)), repeats_(repeats(room)) {}

bool Placement::is_clear(const Body& body) const {
  return grid_.visit_near(box_round(body, room_.gap / 2), [&](int other) {
    return test_gap(body, bodies_[static_cast<std::size_t>(other)], room_.gap).separated;
  });
}

bool Placement::has_room_for(const Ellipse& e) const {
  if (!clear_of_walls(e, room_)) return false;
  Body body = body_of(e);
  return std::all_of(repeats_.begin(), repeats_.end(), [&](Point shift) {
    body.centre = Point{e.x, e.y} + shift;
    return is_clear(body);
  });
}

void Placement::place(const Ellipse& e) {
  bodies_.push_back(body_of(e));
  grid_.add(box_round(bodies_.back(), room_.gap / 2));
}

std::vector<Ellipse> without_collisions(const std::vector<Ellipse>& ellipses, const Room& room) {
  Placement placement(room, ellipses.size());
  std::vector<Ellipse> kept;
  for (const Ellipse& e : ellipses) {
    if (!placement.has_room_for(e)) continue;
    placement.place(e);
    kept.push_back(e);
  }
  return kept;
}

}  // namespace specimen
