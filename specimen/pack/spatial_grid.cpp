#include "specimen/pack/spatial_grid.hpp"

#include <cmath>

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

}  // namespace specimen
