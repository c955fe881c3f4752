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
  for (const std::uint8_t label : mask.labels.data) ++counts[label];
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
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  std::vector<std::int32_t> parent_;
};

template <class T>
Components pieces(const Raster<T>& values, Connectivity connectivity) {
  Components result{Raster<std::int32_t>(values.rows, values.cols, -1), {}};
  Sets sets;
  const bool corners = connectivity == Connectivity::corners;
  for (int r = 0; r < values.rows; ++r)
    for (int c = 0; c < values.cols; ++c) {
      std::int32_t& mine = result.piece(r, c);
      const auto look_at = [&](int row, int col) {
        if (!values.contains(row, col) || values(row, col) != values(r, c)) return;
        const std::int32_t theirs = result.piece(row, col);
        mine = mine < 0 ? theirs : (mine == theirs ? mine : sets.join(mine, theirs));
      };
      look_at(r, c - 1);
      look_at(r - 1, c);
      if (corners) {
        look_at(r - 1, c - 1);
        look_at(r - 1, c + 1);
      }
      if (mine < 0) mine = sets.add();
    }
  std::vector<std::int32_t> number(sets.size(), -1);
  for (std::int32_t& piece : result.piece.data) {
    std::int32_t& n = number[static_cast<std::size_t>(sets.find(piece))];
    if (n < 0) {
      n = result.count();
      result.area.push_back(0);
    }
    piece = n;
    ++result.area[static_cast<std::size_t>(n)];
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
