#include "specimen/convert/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
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

  /// The winner that is no aggregate, with the votes of the ITZ for mortar, which it is the edge of.
  [[nodiscard]] Cell winner_of_the_rest() const {
    std::array<std::int64_t, 256> all = by_phase();
    all[phase::mortar] += std::exchange(all[phase::itz], 0);
    all[phase::aggregate] = 0;
    return winner(all);
  }
  [[nodiscard]] Cell best_grain() const { return best_of(phase::aggregate); }

  /// Of the pixel [-].
  [[nodiscard]] double share_of(std::uint8_t phase) const {
    const std::array<std::int64_t, 256> all = by_phase();
    return static_cast<double>(all[phase]) / static_cast<double>(std::reduce(all.begin(), all.end()));
  }

 private:
  [[nodiscard]] std::array<std::int64_t, 256> by_phase() const {
    std::array<std::int64_t, 256> all{};
    for (const auto& [cell, votes] : votes_) all[phase_of(cell)] += votes;
    return all;
  }
  [[nodiscard]] Cell winner(const std::array<std::int64_t, 256>& by_phase) const {
    return best_of(
        static_cast<std::uint8_t>(std::max_element(by_phase.begin(), by_phase.end()) - by_phase.begin()));
  }
  [[nodiscard]] Cell best_of(std::uint8_t phase) const {
    Cell best = phase;
    std::int64_t most = -1;
    for (const auto& [cell, votes] : votes_)
      if (phase_of(cell) == phase && (votes > most || (votes == most && cell < best))) {
        most = votes;
        best = cell;
      }
    return best;
  }

  std::vector<std::pair<Cell, std::int64_t>> votes_;
};

/// @param count  takes the row, the column and the ballot of each pixel of the mask.
template <class Count>
void hold_votes(const Raster<Cell>& cells, const Resampling& to, const Count& count) {
  const auto row_shares = shares(to, to.source_rows, to.rows),
             col_shares = shares(to, to.source_cols, to.cols);
  Ballot ballot;
  for (int r = 0; r < to.rows; ++r)
    for (int c = 0; c < to.cols; ++c) {
      ballot.clear();
      for (const Share& row : row_shares[static_cast<std::size_t>(r)])
        for (const Share& col : col_shares[static_cast<std::size_t>(c)])
          ballot.add(cells(row.cell, col.cell), row.weight * col.weight);
      count(r, c, ballot);
    }
}

/// What the pixels of a mask hold of a picture.
struct Held {
  Raster<float> aggregate, itz;  ///< shares [-]
  Raster<Cell> grain, rest;      ///< the largest grain, and what there is without aggregate
};

Held count_held(const Raster<Cell>& cells, const Resampling& to) {
  Held seen{{to.rows, to.cols}, {to.rows, to.cols}, {to.rows, to.cols}, {to.rows, to.cols}};
  hold_votes(cells, to, [&](int r, int c, const Ballot& ballot) {
    seen.aggregate(r, c) = static_cast<float>(ballot.share_of(phase::aggregate));
    seen.itz(r, c) = static_cast<float>(ballot.share_of(phase::itz));
    seen.grain(r, c) = ballot.best_grain();
    seen.rest(r, c) = ballot.winner_of_the_rest();
  });
  return seen;
}

/// Calls `visit` with the row and column of the neighbours across the edges of a pixel.
template <class T, class Visit>
void visit_neighbours(const Raster<T>& raster, int r, int c, const Visit& visit) {
  if (r > 0) visit(r - 1, c);
  if (c > 0) visit(r, c - 1);
  if (c + 1 < raster.cols) visit(r, c + 1);
  if (r + 1 < raster.rows) visit(r + 1, c);
}

constexpr float certainly = 0.65F;  ///< share of aggregate with which a pixel is aggregate, whatever the area

/// Where the pixels that are about half aggregate come in an order, first those with most of it, of such with
/// the same those whose neighbours have most.
struct Undecided {
  float share, around;
  std::size_t pixel;
};

/// Pixels that are mostly aggregate are; of the undecided ones as many as keep its area. If a vote alone
/// decided over them, those that tie would all go to one side.
void choose_aggregate(const Held& seen, Raster<Cell>& mask) {
  std::vector<Undecided> undecided;
  double area = 0;
  for (int r = 0; r < mask.rows; ++r)
    for (int c = 0; c < mask.cols; ++c) {
      const float share = seen.aggregate(r, c);
      area += static_cast<double>(share);
      if (share >= certainly) {
        mask(r, c) = seen.grain(r, c);
        area -= 1;
      } else if (share > 1 - certainly) {
        float around = 0;
        visit_neighbours(seen.aggregate, r, c, [&](int y, int x) { around += seen.aggregate(y, x); });
        undecided.push_back({share, around, static_cast<std::size_t>(&mask(r, c) - mask.data.data())});
      }
    }
  std::stable_sort(undecided.begin(), undecided.end(), [](const Undecided& a, const Undecided& b) {
    return a.share != b.share ? a.share > b.share : a.around > b.around;
  });
  const auto chosen = std::clamp<long>(std::lround(area), 0, static_cast<long>(undecided.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(chosen); ++i)
    mask.data[undecided[i].pixel] = seen.grain.data[undecided[i].pixel];
}

/// A ring of one pixel of mortar along the edges of the aggregate that had an ITZ, and what is ITZ for the
/// most part anyway.
void draw_itz(const Held& seen, Raster<Cell>& mask) {
  const auto had = [&](int r, int c) { return seen.itz(r, c) > 0; };
  for (int r = 0; r < mask.rows; ++r)
    for (int c = 0; c < mask.cols; ++c) {
      if (mask(r, c) != phase::mortar) continue;
      bool is_itz = seen.itz(r, c) > 0.5F;
      visit_neighbours(mask, r, c, [&](int y, int x) {
        is_itz = is_itz || (is_aggregate(mask(y, x)) && (had(r, c) || had(y, x)));
      });
      if (is_itz) mask(r, c) = phase::itz;
    }
}

/// An ITZ is thinner than most pixels: no vote would let it live.
Raster<Cell> coarser(const Raster<Cell>& cells, const Resampling& to) {
  const Held seen = count_held(cells, to);
  Raster<Cell> mask = seen.rest;
  choose_aggregate(seen, mask);
  draw_itz(seen, mask);
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

Raster<Cell> resampled(const Raster<Cell>& cells, const Resampling& to) {
  return to.cols > to.source_cols ? at_centres(cells, to) : coarser(cells, to);
}

}  // namespace specimen
