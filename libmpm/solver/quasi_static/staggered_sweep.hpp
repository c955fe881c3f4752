/// Several sweeps over the rows of a grid in one pass, so that the rows are in the cache for all of them.
///
/// A sweep computes the forces of the rows of cells and does something to the rows of nodes between them,
/// upwards; it may change the displacements that it reads. The next sweep follows one row behind. Threads
/// share the rows in bands. Near the border of two bands the sweeps leave out what needs the other band, one
/// row more in every sweep, and make up for it when all bands are done. Every row is computed from the same
/// numbers in the same order on any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "libmpm/solver/force_buffer.hpp"
#include "libmpm/solver/threads.hpp"

namespace mpm {

template <class Real>
class StaggeredSweep {
 public:
  static constexpr int most_sweeps = 2;

  /// @param rows  of cells.   @param cells  padded number of cells in a row.   @param bands  see bands_for().
  void resize(int rows, std::ptrdiff_t cells, int bands) {
    rows_ = rows;
    bands_.resize(static_cast<std::size_t>(bands));
    for (int i = 0; i < bands; ++i) {
      Band& band = bands_[static_cast<std::size_t>(i)];
      band.begin = first_row(i);
      band.end = first_row(i + 1);
      for (auto& sweep : band.sweeps)
        for (ForceBuffer<Real>* buffer : {&sweep.upper[0], &sweep.upper[1], &sweep.lower, &sweep.first_lower})
          buffer->resize(cells);
      for (ForceBuffer<Real>& buffer : band.border) buffer.resize(cells);
    }
    none_.resize(cells);
  }

  /// Bands that are worth their barriers.   @param cells  of the grid.
  [[nodiscard]] static int bands_for(int rows, std::int64_t cells, int threads) {
    return static_cast<int>(
        std::clamp<std::int64_t>(std::min<std::int64_t>(cells / 4096, rows / 8), 1, threads));
  }

  [[nodiscard]] int bands() const { return static_cast<int>(bands_.size()); }

  /// work(row) for every row of nodes, shared by bands.
  template <class Work>
  void each_row(Team& team, const Work& work) const {
    team.share(bands(), [&](int i) {
      for (int row = first_row(i); row < first_row(i + 1); ++row) work(row);
      if (i + 1 == bands()) work(rows_);
    });
  }

  /// @param prepare  prepare(row of nodes), before any sweep needs it.
  /// @param cells    cells(sweep, row of cells, lower, upper): its forces.
  /// @param nodes    nodes(sweep, row of nodes, forces of the cells below, of those above).
  template <class Prepare, class Cells, class Nodes>
  void run(Team& team, int sweeps, const Prepare& prepare, const Cells& cells, const Nodes& nodes) {
    team.share(bands(), [&](int i) { prepare(bands_[static_cast<std::size_t>(i)].begin); });
    team.share(bands(), [&](int i) { inside(static_cast<std::size_t>(i), sweeps, prepare, cells, nodes); });
    if (bands() == 1) return;
    team.share(bands(), [&](int i) {
      if (i > 0) at_border(static_cast<std::size_t>(i), sweeps, cells, nodes);
    });
  }

 private:
  struct Sweep {
    std::array<ForceBuffer<Real>, 2> upper;  ///< of the row of cells at hand and of the one below it, in turn
    ForceBuffer<Real> lower;                 ///< of the row at hand
    ForceBuffer<Real> first_lower;           ///< of the lowest row, kept for the border
  };
  /// The rows of a thread.
  struct Band {
    int begin = 0, end = 0;  ///< rows of cells
    std::array<Sweep, most_sweeps> sweeps;
    std::array<ForceBuffer<Real>, 2> border;  ///< as `upper`
  };

  [[nodiscard]] int first_row(int band) const {
    return static_cast<int>(static_cast<std::int64_t>(rows_) * band / bands());
  }
  static std::size_t turn(int row) { return static_cast<std::size_t>(row % 2); }

  template <class Prepare, class Cells, class Nodes>
  void inside(std::size_t index, int sweeps, const Prepare& prepare, const Cells& cells, const Nodes& nodes) {
    Band& band = bands_[index];
    const bool is_last = index + 1 == bands_.size();
    for (int time = band.begin; time < band.end + (is_last ? sweeps : 0); ++time) {
      if (time + 1 < band.end || (is_last && time + 1 == rows_)) prepare(time + 1);
      for (int s = 0; s < sweeps; ++s) {
        const int row = time - s;
        const int begin = band.begin == 0 ? 0 : band.begin + s;
        if (row < begin || row > rows_ || (!is_last && row >= band.end - s)) continue;
        Sweep& sweep = band.sweeps[static_cast<std::size_t>(s)];
        const ForceBuffer<Real>& below = row == 0 ? none_ : sweep.upper[turn(row + 1)];
        if (row == rows_) {
          nodes(s, row, below, none_);
        } else if (row == begin && row > 0) {
          cells(s, row, sweep.first_lower, sweep.upper[turn(row)]);
        } else {
          cells(s, row, sweep.lower, sweep.upper[turn(row)]);
          nodes(s, row, below, sweep.lower);
        }
      }
    }
  }

  /// What the band and the one below it have left out.
  template <class Cells, class Nodes>
  void at_border(std::size_t index, int sweeps, const Cells& cells, const Nodes& nodes) {
    Band& band = bands_[index];
    for (int s = 0; s < sweeps; ++s) {
      Sweep& sweep = band.sweeps[static_cast<std::size_t>(s)];
      const ForceBuffer<Real>* below =
          &bands_[index - 1].sweeps[static_cast<std::size_t>(s)].upper[turn(band.begin - s - 1)];
      for (int row = band.begin - s; row < band.begin + s; ++row) {
        ForceBuffer<Real>& upper = band.border[turn(row)];
        cells(s, row, sweep.lower, upper);
        nodes(s, row, *below, sweep.lower);
        below = &upper;
      }
      nodes(s, band.begin + s, *below, sweep.first_lower);
    }
  }

  int rows_ = 0;
  std::vector<Band> bands_;
  ForceBuffer<Real> none_;
};

}  // namespace mpm
