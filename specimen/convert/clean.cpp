#include "specimen/convert/clean.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "specimen/body/mask.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {
namespace {

constexpr std::array<std::array<int, 2>, 4> sides{{{-1, 0}, {0, -1}, {0, 1}, {1, 0}}};

template <class Test>
Raster<std::uint8_t> where(const Raster<Cell>& cells, Test test) {
  Raster<std::uint8_t> mask(cells.rows, cells.cols);
  std::transform(cells.data.begin(), cells.data.end(), mask.data.begin(),
                 [&](Cell cell) { return static_cast<std::uint8_t>(test(cell)); });
  return mask;
}

/// Pixels of the mask that a disc which stays inside the mask does not cover.
Raster<std::uint8_t> out_of_reach(const Raster<std::uint8_t>& mask, double radius) {
  const auto r = static_cast<float>(radius);
  const Raster<float> depth = distance_to_zero(mask);
  Raster<std::uint8_t> not_core(mask.rows, mask.cols);
  std::transform(depth.data.begin(), depth.data.end(), not_core.data.begin(),
                 [&](float d) { return static_cast<std::uint8_t>(d <= r); });
  const Raster<float> from_core = distance_to_zero(not_core);
  Raster<std::uint8_t> out(mask.rows, mask.cols);
  for (std::size_t i = 0; i < out.size(); ++i) out.data[i] = mask.data[i] != 0 && from_core.data[i] > r;
  return out;
}

/// Give the marked pixels the cell of their nearest neighbour that may spread, layer by layer.
/// @return pixels changed; marked pixels that nothing reaches stay as they are.
std::int64_t grow_into(Raster<Cell>& cells, Raster<std::uint8_t> marked,
                       const std::function<bool(Cell)>& may_spread) {
  using Pixel = std::pair<int, int>;
  std::vector<Pixel> layer;
  for (int r = 0; r < cells.rows; ++r)
    for (int c = 0; c < cells.cols; ++c)
      if (marked(r, c) == 0 && may_spread(cells(r, c))) layer.emplace_back(r, c);
  std::int64_t changed = 0;
  while (!layer.empty()) {
    std::vector<Pixel> next;
    for (const auto& [r, c] : layer)
      for (const auto& [dr, dc] : sides) {
        const int row = r + dr, col = c + dc;
        if (!cells.contains(row, col) || marked(row, col) == 0) continue;
        marked(row, col) = 0;
        cells(row, col) = cells(r, c);
        next.emplace_back(row, col);
        ++changed;
      }
    layer = std::move(next);
  }
  return changed;
}

/// Pieces of a picture and the lengths of their common boundaries.
struct Neighbourhood {
  Components pieces;
  std::vector<Cell> cell;                                      ///< of each piece
  std::vector<std::map<std::int32_t, std::int64_t>> boundary;  ///< per piece: neighbour -> pixel edges shared

  explicit Neighbourhood(const Raster<Cell>& cells) : pieces(connected_pieces(cells, Connectivity::edges)) {
    cell.resize(pieces.area.size());
    boundary.resize(pieces.area.size());
    for (int r = 0; r < cells.rows; ++r)
      for (int c = 0; c < cells.cols; ++c) {
        const std::int32_t mine = pieces.piece(r, c);
        cell[static_cast<std::size_t>(mine)] = cells(r, c);
        if (r + 1 < cells.rows) touch(mine, pieces.piece(r + 1, c));
        if (c + 1 < cells.cols) touch(mine, pieces.piece(r, c + 1));
      }
  }
  void touch(std::int32_t a, std::int32_t b) {
    if (a == b) return;
    ++boundary[static_cast<std::size_t>(a)][b];
    ++boundary[static_cast<std::size_t>(b)][a];
  }
};

/// Give every pixel the cell of its piece.
void paint(Raster<Cell>& cells, const Neighbourhood& n) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells.data[i] = n.cell[static_cast<std::size_t>(n.pieces.piece.data[i])];
}

/// Cell with the longest boundary to a piece among its settled neighbours; -1 when it has none.
Cell strongest_neighbour(const Neighbourhood& n, std::size_t piece,
                         const std::vector<std::uint8_t>& settled) {
  std::map<Cell, std::int64_t> length;
  for (const auto& [other, edges] : n.boundary[piece])
    if (settled[static_cast<std::size_t>(other)] != 0)
      length[n.cell[static_cast<std::size_t>(other)]] += edges;
  Cell best = -1;
  std::int64_t longest = 0;
  for (const auto& [cell, edges] : length)
    if (edges > longest) {
      longest = edges;
      best = cell;
    }
  return best;
}

}  // namespace

Changed open_phase(Raster<Cell>& cells, std::uint8_t phase, double radius) {
  const auto in_phase = [&](Cell cell) { return phase_of(cell) == phase; };
  Changed changed;
  changed.pixels = grow_into(cells, out_of_reach(where(cells, in_phase), radius),
                             [&](Cell cell) { return !in_phase(cell); });
  return changed;
}

Changed close_aggregates(Raster<Cell>& cells, double radius) {
  Changed changed;
  changed.pixels = grow_into(
      cells, out_of_reach(where(cells, [](Cell cell) { return !is_aggregate(cell); }), radius), is_aggregate);
  return changed;
}

Changed drop_islands(Raster<Cell>& cells, const LeastArea& least) {
  Neighbourhood n(cells);
  const std::size_t count = n.cell.size();
  std::vector<std::uint8_t> settled(count);
  std::vector<std::size_t> islands;
  for (std::size_t i = 0; i < count; ++i) {
    settled[i] = static_cast<double>(n.pieces.area[i]) >= least[phase_of(n.cell[i])];
    if (settled[i] == 0) islands.push_back(i);
  }
  Changed changed;
  while (!islands.empty()) {
    // All islands of a round decide by what stood before it, so that their order plays no part.
    std::vector<std::pair<std::size_t, Cell>> joins;
    for (const std::size_t i : islands)
      if (const Cell cell = strongest_neighbour(n, i, settled); cell >= 0) joins.emplace_back(i, cell);
    if (joins.empty()) break;
    for (const auto& [i, cell] : joins) {
      ++changed.pieces;
      if (cell != n.cell[i]) changed.pixels += n.pieces.area[i];
      n.cell[i] = cell;
      settled[i] = 1;
    }
    std::erase_if(islands, [&](std::size_t i) { return settled[i] != 0; });
  }
  paint(cells, n);
  return changed;
}

Changed absorb(Raster<Cell>& cells, std::uint8_t phase, std::uint8_t into, double share) {
  Neighbourhood n(cells);
  const std::vector<Cell> before = n.cell;
  Changed changed;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (phase_of(before[i]) != phase) continue;
    std::int64_t all = 0, inside = 0, longest = 0;
    std::int32_t host = -1;
    for (const auto& [other, edges] : n.boundary[i]) {
      all += edges;
      if (phase_of(before[static_cast<std::size_t>(other)]) != into) continue;
      inside += edges;
      if (edges <= longest) continue;
      longest = edges;
      host = other;
    }
    if (host < 0 || static_cast<double>(inside) <= share * static_cast<double>(all)) continue;
    if (4 * n.pieces.area[i] > n.pieces.area[static_cast<std::size_t>(host)]) continue;
    n.cell[i] = before[static_cast<std::size_t>(host)];
    ++changed.pieces;
    changed.pixels += n.pieces.area[i];
  }
  paint(cells, n);
  return changed;
}

Changed fill_holes(Raster<Cell>& cells) {
  // Aggregate hangs together by edges, so what is not aggregate hangs together by corners too.
  Raster<std::uint8_t> outside = where(cells, [](Cell cell) { return !is_aggregate(cell); });
  const Components pieces = connected_pieces(outside, Connectivity::corners);
  const auto count = pieces.area.size();
  std::vector<std::uint8_t> is_hole(count, 1);
  std::vector<Cell> around(count, -1);
  for (int r = 0; r < cells.rows; ++r)
    for (int c = 0; c < cells.cols; ++c) {
      const auto piece = static_cast<std::size_t>(pieces.piece(r, c));
      if (outside(r, c) == 0) {
        is_hole[piece] = 0;
        continue;
      }
      for (const auto& [dr, dc] : sides) {
        if (!cells.contains(r + dr, c + dc)) {
          is_hole[piece] = 0;
          continue;
        }
        const Cell next = cells(r + dr, c + dc);
        if (!is_aggregate(next)) continue;
        if (around[piece] >= 0 && around[piece] != next) is_hole[piece] = 0;
        around[piece] = next;
      }
    }
  Changed changed;
  for (std::size_t i = 0; i < count; ++i) changed.pieces += is_hole[i];
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto piece = static_cast<std::size_t>(pieces.piece.data[i]);
    if (is_hole[piece] == 0) continue;
    cells.data[i] = around[piece];
    ++changed.pixels;
  }
  return changed;
}

std::int64_t largest_aggregate(const Raster<Cell>& cells) {
  const Components pieces = connected_pieces(cells, Connectivity::edges);
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (is_aggregate(cells.data[i]))
      largest = std::max(largest, pieces.area[static_cast<std::size_t>(pieces.piece.data[i])]);
  return largest;
}

}  // namespace specimen
