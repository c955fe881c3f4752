#include "specimen/convert/shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Call `meet(i, j)` for the places of each two pixels side by side that differ.
template <class Meet>
void for_each_edge(const Raster<std::int32_t>& code, Meet meet) {
  const auto cols = static_cast<std::size_t>(code.cols);
  for (int r = 0; r < code.rows; ++r) {
    const std::size_t row = static_cast<std::size_t>(r) * cols;
    const bool last = r + 1 == code.rows;
    for (std::size_t c = 0; c < cols; ++c) {
      const std::size_t i = row + c;
      if (c + 1 < cols && code.data[i] != code.data[i + 1]) meet(i, i + 1);
      if (!last && code.data[i] != code.data[i + cols]) meet(i, i + cols);
    }
  }
}

/// Edges of each piece with others, and its pixels along the border of the picture.
struct Rims {
  std::vector<double> edges, border;
};

template <class Visit>
void for_each_border_pixel(int rows, int cols, Visit visit) {
  for (int c = 0; c < cols; ++c) visit(0, c), visit(rows - 1, c);
  for (int r = 0; r < rows; ++r) visit(r, 0), visit(r, cols - 1);
}

/// Sizes of the pieces, gathered by value; the largest piece of each value.
std::vector<std::int32_t> gather_pieces(const Raster<std::int32_t>& code, const Components& pieces,
                                        std::vector<ValueShape>& shapes) {
  std::vector<std::int32_t> value_of(pieces.area.size(), -1), largest(shapes.size(), -1);
  for (std::size_t i = 0; i < code.size(); ++i) value_of[index(pieces.piece.data[i])] = code.data[i];
  for (std::size_t p = 0; p < value_of.size(); ++p) {
    if (value_of[p] < 0) continue;
    ValueShape& shape = shapes[index(value_of[p])];
    const auto area = static_cast<double>(pieces.area[p]);
    shape.area += area;
    shape.pieces += 1;
    shape.typical += area * area;
    if (area <= shape.largest) continue;
    shape.largest = area;
    largest[index(value_of[p])] = static_cast<std::int32_t>(p);
  }
  for (ValueShape& shape : shapes)
    if (shape.area > 0) shape.typical /= shape.area;
  return largest;
}

}  // namespace

Shapes shapes_of(const Raster<std::int32_t>& code, int count) {
  Shapes shapes;
  shapes.of.resize(index(count));
  if (count <= most_in_contact) shapes.contact = Raster<double>(count, count, 0.0);
  const Components pieces = connected_pieces(code, Connectivity::edges);
  const std::vector<std::int32_t> largest = gather_pieces(code, pieces, shapes.of);

  Rims rims{std::vector<double>(pieces.area.size(), 0), std::vector<double>(pieces.area.size(), 0)};
  double all = 0;
  for_each_edge(code, [&](std::size_t i, std::size_t j) {
    ++all;
    const std::int32_t a = code.data[i], b = code.data[j];
    for (const auto& [place, value] : {std::pair(i, a), std::pair(j, b)}) {
      ++rims.edges[index(pieces.piece.data[place])];
      if (value >= 0) ++shapes.of[index(value)].perimeter;
    }
    if (a >= 0 && b >= 0 && !shapes.contact.empty()) ++shapes.contact(a, b), ++shapes.contact(b, a);
  });
  double rim = 0;
  for_each_border_pixel(code.rows, code.cols, [&](int r, int c) {
    if (code(r, c) < 0) return;
    ++rim;
    ++rims.border[index(pieces.piece(r, c))];
  });
  for (std::size_t v = 0; v < shapes.of.size(); ++v) {
    if (largest[v] < 0) continue;
    shapes.of[v].reach = all > 0 ? rims.edges[index(largest[v])] / all : 0;
    shapes.of[v].border = rim > 0 ? rims.border[index(largest[v])] / rim : 0;
  }
  return shapes;
}

std::vector<int> neighbours_of(const Raster<std::int32_t>& code, int count) {
  std::vector<int> neighbours(index(count), 0);
  std::unordered_set<std::uint64_t> met;
  std::uint64_t last = 0;
  for_each_edge(code, [&](std::size_t i, std::size_t j) {
    const std::int32_t a = std::min(code.data[i], code.data[j]), b = std::max(code.data[i], code.data[j]);
    if (a < 0) return;
    const std::uint64_t pair = static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint32_t>(b);
    if (pair == last || !met.insert(last = pair).second) return;
    ++neighbours[index(a)];
    ++neighbours[index(b)];
  });
  return neighbours;
}

std::vector<double> solidity(const Raster<std::int32_t>& code, int count) {
  std::vector<double> solid(index(count), 0), area(index(count), 0);
  for (int r = 0; r < code.rows; ++r)
    for (int c = 0; c < code.cols; ++c) {
      const std::int32_t mine = code(r, c);
      if (mine < 0) continue;
      ++area[index(mine)];
      int alike = 0;
      for (int dr = -1; dr <= 1 && alike < 3; ++dr)
        for (int dc = -1; dc <= 1 && alike < 3; ++dc)
          alike += (dr != 0 || dc != 0) && code.contains(r + dr, c + dc) && code(r + dr, c + dc) == mine;
      solid[index(mine)] += alike >= 3;
    }
  for (std::size_t v = 0; v < solid.size(); ++v)
    if (area[v] > 0) solid[v] /= area[v];
  return solid;
}

}  // namespace specimen
