#include "specimen/convert/grains.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "specimen/body/mask.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {

std::vector<std::int32_t> grain_numbers(const Raster<Cell>& cells) {
  std::vector<std::int32_t> numbers;
  for (const Cell cell : cells.data)
    if (cell >= first_grain && (numbers.empty() || numbers.back() != cell - first_grain))
      numbers.push_back(cell - first_grain);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

int number_grains(Raster<Cell>& cells) {
  const Components pieces = connected_pieces(cells, Connectivity::edges);
  std::vector<std::int32_t> number(pieces.area.size(), 0);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_aggregate(cells.data[i])) continue;
    std::int32_t& n = number[static_cast<std::size_t>(pieces.piece.data[i])];
    if (n == 0) n = ++count;
    cells.data[i] = grain(n);
  }
  return count;
}

namespace {

constexpr Cell open_cut = -1;  ///< a pixel of a cut that belongs to no grain yet

/// Give pixels of cuts the grains beside them, layer by layer from the grains inwards.
/// @return those that no grain is beside.
std::vector<std::size_t> close_cuts(Raster<Cell>& cells, std::vector<std::size_t> open) {
  const auto cols = static_cast<std::size_t>(cells.cols);
  while (!open.empty()) {
    std::vector<std::pair<std::size_t, Cell>> joined;
    std::vector<std::size_t> left;
    for (const std::size_t i : open) {
      Cell beside = 0;
      const auto look = [&](bool is_there, std::size_t at) {
        if (is_there && cells.data[at] >= first_grain && beside == 0) beside = cells.data[at];
      };
      look(i >= cols, i - cols);
      look(i % cols > 0, i - 1);
      look(i % cols + 1 < cols, i + 1);
      look(i + cols < cells.size(), i + cols);
      if (beside != 0)
        joined.emplace_back(i, beside);
      else
        left.push_back(i);
    }
    if (joined.empty()) break;
    for (const auto& [i, beside] : joined) cells.data[i] = beside;
    open = std::move(left);
  }
  return open;
}

}  // namespace

int cut_grains(Raster<Cell>& cells, const Raster<std::uint8_t>& cuts) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_aggregate(cells.data[i])) continue;
    cells.data[i] = cuts.data[i] != 0 ? open_cut : phase::aggregate;
    if (cuts.data[i] != 0) open.push_back(i);
  }
  const int count = number_grains(cells);
  open = close_cuts(cells, std::move(open));
  for (const std::size_t i : open) cells.data[i] = phase::aggregate;
  return open.empty() ? count : number_grains(cells);
}

namespace {

/// Sets of numbers 0 to count - 1 that grow together; the smallest number of a set stands for it.
class Sets {
 public:
  explicit Sets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0U); }
  [[nodiscard]] std::size_t root(std::size_t one) {
    while (up_[one] != one) one = up_[one] = up_[up_[one]];
    return one;
  }
  void unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    up_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> up_;
};

}  // namespace

int join_grains(Raster<Cell>& cells, const Raster<std::uint8_t>& marks) {
  const std::vector<std::int32_t> numbers = grain_numbers(cells);
  const auto place_of = [&](Cell cell) {
    return static_cast<std::size_t>(std::lower_bound(numbers.begin(), numbers.end(), cell - first_grain) -
                                    numbers.begin());
  };
  const Components strokes = connected_pieces(marks, Connectivity::corners);
  std::vector<std::int32_t> first(strokes.area.size(), -1);  // grain that each stroke met first
  Sets sets(numbers.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (marks.data[i] == 0 || cells.data[i] < first_grain) continue;
    std::int32_t& met = first[static_cast<std::size_t>(strokes.piece.data[i])];
    const std::size_t here = place_of(cells.data[i]);
    if (met < 0) met = static_cast<std::int32_t>(here);
    sets.unite(static_cast<std::size_t>(met), here);
  }
  for (Cell& cell : cells.data)
    if (cell >= first_grain) cell = grain(numbers[sets.root(place_of(cell))]);
  return static_cast<int>(grain_numbers(cells).size());
}

namespace {

/// Height of the landscape: distance to the rim of the grain, in sixteenths of a pixel.
Raster<std::int32_t> heights_of(const Raster<Cell>& cells) {
  Raster<std::uint8_t> inside(cells.rows, cells.cols, 0);
  for (int r = 0; r < cells.rows; ++r)
    for (int c = 0; c < cells.cols; ++c) {
      const Cell cell = cells(r, c);
      // A rim between two grains that touch has no pixel of its own: the pixels on both sides play it.
      const auto other_grain = [&](int row, int col) {
        return cells.contains(row, col) && is_aggregate(cells(row, col)) && cells(row, col) != cell;
      };
      inside(r, c) = is_aggregate(cell) && !other_grain(r - 1, c) && !other_grain(r + 1, c) &&
                     !other_grain(r, c - 1) && !other_grain(r, c + 1);
    }
  const Raster<float> distance = distance_to_zero(inside);
  Raster<std::int32_t> heights(cells.rows, cells.cols);
  std::transform(distance.data.begin(), distance.data.end(), heights.data.begin(),
                 [](float d) { return static_cast<std::int32_t>(std::lround(d * 16)); });
  return heights;
}

/// Pixels of the grains from the highest to the lowest, row by row among equals.
std::vector<std::int32_t> downhill(const Raster<Cell>& cells, const Raster<std::int32_t>& heights) {
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (is_aggregate(cells.data[i])) order.push_back(static_cast<std::int32_t>(i));
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return heights.data[static_cast<std::size_t>(a)] > heights.data[static_cast<std::size_t>(b)];
  });
  return order;
}

/// Water that falls: lakes round the summits grow downhill, and where two meet they become one unless the
/// saddle is deep.
class Flood {
 public:
  Flood(const Raster<Cell>& cells, double depth)
      : cells_(cells), heights_(heights_of(cells)), lake_(cells.rows, cells.cols, -1), depth_(depth) {
    for (const std::int32_t pixel : downhill(cells, heights_)) visit(pixel / cells.cols, pixel % cells.cols);
  }
  [[nodiscard]] std::int32_t lake_at(std::size_t pixel) { return root(lake_.data[pixel]); }
  [[nodiscard]] std::size_t lakes() const { return up_.size(); }

 private:
  void visit(int r, int c) {
    const std::int32_t height = heights_(r, c);
    std::int32_t mine = -1, from_height = -1;
    const auto meet = [&](int row, int col) {
      if (!cells_.contains(row, col) || cells_(row, col) != cells_(r, c) || lake_(row, col) < 0) return;
      const std::int32_t theirs = root(lake_(row, col));
      if (mine >= 0 && theirs != mine) try_to_join(mine, theirs, height);
      if (heights_(row, col) > from_height) {
        from_height = heights_(row, col);
        mine = theirs;
      }
      mine = root(mine);
    };
    meet(r - 1, c);
    meet(r, c - 1);
    meet(r, c + 1);
    meet(r + 1, c);
    lake_(r, c) = mine >= 0 ? mine : add_summit(height);
  }

  std::int32_t add_summit(std::int32_t height) {
    up_.push_back(static_cast<std::int32_t>(up_.size()));
    summit_.push_back(height);
    return up_.back();
  }

  void try_to_join(std::int32_t a, std::int32_t b, std::int32_t saddle) {
    constexpr std::int32_t least_summit = 2 * 16;  // a bump of under two pixels is no grain
    std::int32_t& summit_a = summit_[static_cast<std::size_t>(a)];
    std::int32_t& summit_b = summit_[static_cast<std::size_t>(b)];
    const std::int32_t lower = std::min(summit_a, summit_b);
    if (lower >= least_summit && saddle < (1 - depth_) * lower) return;
    const bool into_a = summit_a > summit_b || (summit_a == summit_b && a < b);
    up_[static_cast<std::size_t>(into_a ? b : a)] = into_a ? a : b;
  }

  std::int32_t root(std::int32_t lake) {
    while (up_[static_cast<std::size_t>(lake)] != lake) {
      std::int32_t& up = up_[static_cast<std::size_t>(lake)];
      up = up_[static_cast<std::size_t>(up)];
      lake = up;
    }
    return lake;
  }

  const Raster<Cell>& cells_;
  Raster<std::int32_t> heights_;
  Raster<std::int32_t> lake_;
  double depth_;
  std::vector<std::int32_t> up_, summit_;
};

}  // namespace

int split_grains(Raster<Cell>& cells, double depth) {
  Flood flood(cells, depth);
  std::vector<std::int32_t> number(flood.lakes(), 0);
  std::int32_t count = 0;
  Raster<Cell> split = cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_aggregate(cells.data[i])) continue;
    std::int32_t& n = number[static_cast<std::size_t>(flood.lake_at(i))];
    if (n == 0) n = ++count;
    split.data[i] = grain(n);
  }
  cells = std::move(split);
  return count;
}

}  // namespace specimen
