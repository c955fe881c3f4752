#include "specimen/body/mask.hpp"

#include <algorithm>
#include <utility>

#include "specimen/body/error.hpp"

namespace specimen {

std::vector<std::string> standard_phases() { return {"void", "aggregate", "mortar", "itz"}; }

std::uint8_t label_of(std::vector<std::string>& phases, std::string_view name) {
  constexpr std::size_t most_phases = 256;
  const auto found = std::find(phases.begin(), phases.end(), name);
  if (found != phases.end()) return static_cast<std::uint8_t>(found - phases.begin());
  if (name.empty()) throw Error("phase", "an empty name", "must have at least one letter");
  if (phases.size() >= most_phases) {
    throw Error("phase", std::string(name), "at most 256 phases are allowed",
                "give several phases the same name");
  }
  phases.emplace_back(name);
  return static_cast<std::uint8_t>(phases.size() - 1);
}

std::vector<std::int64_t> count_labels(const LabelledMask& mask) {
  std::vector<std::int64_t> counts(256, 0);
  const std::vector<std::uint8_t>& labels = mask.labels.data;
  for (std::size_t first = 0, end = 0; first < labels.size(); first = end) {  // runs: neighbours are alike
    for (end = first + 1; end < labels.size() && labels[end] == labels[first];) ++end;
    counts[labels[first]] += static_cast<std::int64_t>(end - first);
  }
  const auto last = std::find_if(counts.rbegin(), counts.rend(), [](std::int64_t n) { return n > 0; });
  const auto used = static_cast<std::size_t>(counts.rend() - last);
  if (used > mask.phases.size()) {
    throw Error("mask", "label " + std::to_string(used - 1),
                "has no name: there are " + std::to_string(mask.phases.size()) + " phases");
  }
  counts.resize(mask.phases.size());
  return counts;
}

namespace {

/// Union-find over provisional numbers; the smallest number of a set stands for it.
class Sets {
 public:
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  std::int32_t find(std::int32_t i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      std::int32_t& up = parent_[static_cast<std::size_t>(i)];
      up = parent_[static_cast<std::size_t>(up)];  // halve the path on the way
      i = up;
    }
    return i;
  }
  std::int32_t join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (b < a) std::swap(a, b);
    parent_[static_cast<std::size_t>(b)] = a;
    return a;
  }
  /// Number the sets 0, 1, ... by their first numbers, in place of all else: only number_of() is of use after
  /// it.
  /// @return how many there are.
  std::int32_t number_sets() {
    std::int32_t count = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      const auto up = static_cast<std::size_t>(parent_[i]);  // at most i, and numbered already if less
      parent_[i] = up == i ? count++ : parent_[up];
    }
    return count;
  }
  [[nodiscard]] std::int32_t number_of(std::int32_t i) const { return parent_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<std::int32_t> parent_;
};

template <class T>
Components pieces(const Raster<T>& values, Connectivity connectivity) {
  Components result{Raster<std::int32_t>(values.rows, values.cols), {}};
  Sets sets;
  const int reach = connectivity == Connectivity::corners ? 1 : 0;
  for (int r = 0; r < values.rows; ++r) {
    const T* row = &values(r, 0);
    std::int32_t* piece = &result.piece(r, 0);
    for (int first = 0, end = 0; first < values.cols; first = end) {
      const T value = row[first];
      for (end = first + 1; end < values.cols && row[end] == value;) ++end;
      std::int32_t mine = -1;
      if (r > 0) {
        const T* above = row - values.cols;
        const std::int32_t* pieces_above = piece - values.cols;
        std::int32_t last = -1;
        for (int c = std::max(0, first - reach); c < std::min(values.cols, end + reach); ++c) {
          if (above[c] != value || pieces_above[c] == last) continue;
          last = pieces_above[c];
          mine = mine < 0 ? last : (mine == last ? mine : sets.join(mine, last));
        }
      }
      if (mine < 0) mine = sets.add();
      std::fill(piece + first, piece + end, mine);
    }
  }
  result.area.assign(static_cast<std::size_t>(sets.number_sets()), 0);
  std::vector<std::int32_t>& piece = result.piece.data;
  for (std::size_t first = 0, end = 0; first < piece.size(); first = end) {
    const std::int32_t provisional = piece[first];
    for (end = first + 1; end < piece.size() && piece[end] == provisional;) ++end;
    const std::int32_t n = sets.number_of(provisional);
    std::fill(&piece[first], &piece[first] + (end - first), n);
    result.area[static_cast<std::size_t>(n)] += static_cast<std::int64_t>(end - first);
  }
  return result;
}

}  // namespace

Components connected_pieces(const Raster<std::int32_t>& values, Connectivity connectivity) {
  return pieces(values, connectivity);
}

Components connected_pieces(const Raster<std::uint8_t>& values, Connectivity connectivity) {
  return pieces(values, connectivity);
}

}  // namespace specimen
