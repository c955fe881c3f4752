#include "specimen/convert/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "specimen/body/error.hpp"

namespace specimen {
namespace {

/// How much of a mask pixel a cell covers along one axis; whole numbers in units of 1 / mask columns of a
/// picture pixel, so that a vote is exact.
struct Share {
  int cell = 0;
  std::int64_t weight = 0;
};

/// Cells under each mask pixel along one axis of `source` picture pixels.
std::vector<std::vector<Share>> shares(const Resampling& to, int source, int count) {
  std::vector<std::vector<Share>> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const std::int64_t begin = std::int64_t{i} * to.source_cols;
    const std::int64_t end = std::min(begin + to.source_cols, std::int64_t{source} * to.cols);
    const std::int64_t cell_length = std::int64_t{to.factor} * to.cols;
    for (std::int64_t cell = begin / cell_length; cell * cell_length < end; ++cell)
      all[static_cast<std::size_t>(i)].push_back(
          {static_cast<int>(cell),
           std::min(end, (cell + 1) * cell_length) - std::max(begin, cell * cell_length)});
  }
  return all;
}

/// Votes for the cells met under one mask pixel; there are mostly one or two.
class Ballot {
 public:
  void add(Cell cell, std::int64_t weight) {
    for (auto& [known, votes] : votes_)
      if (known == cell) {
        votes += weight;
        return;
      }
    votes_.emplace_back(cell, weight);
  }
  void clear() { votes_.clear(); }

  [[nodiscard]] Cell winner() const {
    std::array<std::int64_t, 256> by_phase{};
    for (const auto& [cell, votes] : votes_) by_phase[phase_of(cell)] += votes;
    const auto phase =
        static_cast<std::uint8_t>(std::max_element(by_phase.begin(), by_phase.end()) - by_phase.begin());
    Cell best = phase;
    std::int64_t most = -1;
    for (const auto& [cell, votes] : votes_)
      if (phase_of(cell) == phase && (votes > most || (votes == most && cell < best))) {
        most = votes;
        best = cell;
      }
    return best;
  }

 private:
  std::vector<std::pair<Cell, std::int64_t>> votes_;
};

Raster<Cell> majority(const Raster<Cell>& cells, const Resampling& to) {
  const auto row_shares = shares(to, to.source_rows, to.rows),
             col_shares = shares(to, to.source_cols, to.cols);
  Raster<Cell> mask(to.rows, to.cols);
  Ballot ballot;
  for (int r = 0; r < to.rows; ++r)
    for (int c = 0; c < to.cols; ++c) {
      ballot.clear();
      for (const Share& row : row_shares[static_cast<std::size_t>(r)])
        for (const Share& col : col_shares[static_cast<std::size_t>(c)])
          ballot.add(cells(row.cell, col.cell), row.weight * col.weight);
      mask(r, c) = ballot.winner();
    }
  return mask;
}

/// Cell under the centre of each mask pixel.
Raster<Cell> at_centres(const Raster<Cell>& cells, const Resampling& to) {
  const auto cell_at = [&](int i, int count) {
    const std::int64_t at =
        (2 * std::int64_t{i} + 1) * to.source_cols / (2 * std::int64_t{to.cols} * to.factor);
    return static_cast<int>(std::min<std::int64_t>(at, count - 1));
  };
  Raster<Cell> mask(to.rows, to.cols);
  for (int r = 0; r < to.rows; ++r)
    for (int c = 0; c < to.cols; ++c) mask(r, c) = cells(cell_at(r, cells.rows), cell_at(c, cells.cols));
  return mask;
}

}  // namespace

Resampling choose_mask_size(int source_rows, int source_cols, int factor, int pixels) {
  Resampling to{source_rows, source_cols, factor, 0, pixels};
  const double rows = source_rows / to.ratio();
  if (rows < 1.5)
    throw Error("convert.pixels", std::to_string(pixels) + " columns",
                "leave " + std::to_string(rows) + " rows of a picture of " + std::to_string(source_cols) +
                    " x " + std::to_string(source_rows) + " pixels, and two are needed",
                "ask for more columns");
  to.rows = 2 * static_cast<int>(std::floor((rows + 0.5) / 2));
  return to;
}

Raster<Cell> resampled(const Raster<Cell>& cells, const Resampling& to) {
  if (to.cols > to.source_cols) return at_centres(cells, to);
  return majority(cells, to);
}

}  // namespace specimen
