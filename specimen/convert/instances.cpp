#include "specimen/convert/instances.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>

#include "specimen/convert/shapes.hpp"

namespace specimen {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Share of the pixels of a value that lie in the middle of 3 x 3 pixels of it: 0 for a line.
double core_share(const Raster<std::int32_t>& code, std::int32_t value) {
  double core = 0, all = 0;
  for (int r = 0; r < code.rows; ++r)
    for (int c = 0; c < code.cols; ++c) {
      if (code(r, c) != value) continue;
      ++all;
      bool inside = true;
      for (int dr = -1; dr <= 1 && inside; ++dr)
        for (int dc = -1; dc <= 1 && inside; ++dc)
          inside = code.contains(r + dr, c + dc) && code(r + dr, c + dc) == value;
      core += inside;
    }
  return all > 0 ? core / all : 0;
}

/// Values in the 3 x 3 pixels round a place, the line left out; at most nine.
struct Surroundings {
  std::array<std::int32_t, 9> values{};
  std::size_t count = 0;
  void add(std::int32_t value) {
    if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), value) ==
        values.begin() + static_cast<std::ptrdiff_t>(count))
      values[count++] = value;
  }
};

Surroundings round_pixel(const Raster<std::int32_t>& code, int r, int c, std::int32_t line) {
  Surroundings found;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc)
      if (code.contains(r + dr, c + dc) && code(r + dr, c + dc) != line && code(r + dr, c + dc) >= 0)
        found.add(code(r + dr, c + dc));
  return found;
}

template <class Visit>
void for_each_pixel_of(const Raster<std::int32_t>& code, std::int32_t value, Visit visit) {
  for (int r = 0; r < code.rows; ++r)
    for (int c = 0; c < code.cols; ++c)
      if (code(r, c) == value) visit(r, c);
}

/// How many others each value meets across the line.
std::vector<int> neighbours_across(const ValueMap& map, std::int32_t line) {
  std::vector<int> neighbours(map.values.size(), 0);
  std::unordered_set<std::uint64_t> met;
  for_each_pixel_of(map.code, line, [&](int r, int c) {
    const Surroundings found = round_pixel(map.code, r, c, line);
    for (std::size_t i = 0; i < found.count; ++i)
      for (std::size_t j = i + 1; j < found.count; ++j) {
        const auto [a, b] = std::minmax(found.values[i], found.values[j]);
        if (!met.insert(static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint32_t>(b)).second)
          continue;
        ++neighbours[at(a)];
        ++neighbours[at(b)];
      }
  });
  return neighbours;
}

std::int32_t most_of(const std::vector<int>& counts) {
  return static_cast<std::int32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

/// Values in many small pieces that are no grains: pores without numbers.
std::vector<std::int32_t> scattered(const ValueMap& map, const GrainMap& grains) {
  std::vector<std::int32_t> voids;
  const std::int32_t lowest = 0;
  if (map.colours || lowest == grains.matrix || lowest == grains.line || map.values.front() > 0) return voids;
  double area = 0;
  for (const std::int32_t code : map.code.data) area += code == lowest;
  if (static_cast<double>(largest_pieces(map.code, map.count())[at(lowest)]) < 0.6 * area)
    voids.push_back(lowest);
  return voids;
}

}  // namespace

GrainMap understand_grains(const ValueMap& map) {
  constexpr double nearly_all = 0.8, half = 0.5, no_core = 0.1;
  GrainMap grains;
  if (map.count() < 2) return grains;
  const std::vector<int> touching = neighbours_of(map.code, map.count());
  const double others = map.count() - 1;
  const std::int32_t busiest = most_of(touching);
  if (touching[at(busiest)] < half * others) return grains;
  if (touching[at(busiest)] >= nearly_all * others && core_share(map.code, busiest) < no_core) {
    const std::vector<int> across = neighbours_across(map, busiest);
    const std::int32_t matrix = most_of(across);
    const bool has_matrix = across[at(matrix)] >= half * (others - 1);
    grains.matrix = has_matrix ? matrix : busiest;
    if (has_matrix) grains.line = busiest;
  } else {
    grains.matrix = busiest;
    // Of two that touch as many: 0, as most programs have it, or the one that is more of the picture.
    const auto zero = std::find(map.values.begin(), map.values.end(), 0);
    const bool is_zero =
        zero != map.values.end() && !map.colours &&
        touching[static_cast<std::size_t>(zero - map.values.begin())] == touching[at(busiest)];
    if (is_zero) grains.matrix = static_cast<std::int32_t>(zero - map.values.begin());
    for (std::int32_t v = 0; !is_zero && v < map.count(); ++v)
      if (v != busiest && touching[at(v)] == touching[at(busiest)]) {
        const std::vector<std::int64_t> largest = largest_pieces(map.code, map.count());
        if (largest[at(v)] > largest[at(grains.matrix)]) grains.matrix = v;
      }
  }
  grains.voids = scattered(map, grains);
  return grains;
}

bool looks_like_grains(const ValueMap& map) {
  constexpr int least_grains = 5;
  constexpr double nearly = 0.9;
  if (map.count() - 1 < least_grains) return false;
  const GrainMap grains = understand_grains(map);
  if (grains.matrix < 0) return false;
  std::vector<std::int64_t> area(map.values.size(), 0);
  for (const std::int32_t code : map.code.data)
    if (code >= 0) ++area[at(code)];
  const std::vector<std::int64_t> largest = largest_pieces(map.code, map.count());
  int whole = 0, numbered = 0;
  for (std::int32_t v = 0; v < map.count(); ++v) {
    const bool other = v == grains.matrix || v == grains.line ||
                       std::find(grains.voids.begin(), grains.voids.end(), v) != grains.voids.end();
    if (other || area[at(v)] == 0) continue;
    ++numbered;
    whole += static_cast<double>(largest[at(v)]) >= nearly * static_cast<double>(area[at(v)]);
  }
  return numbered >= least_grains && whole >= nearly * numbered;
}

void dissolve_line(ValueMap& map, const GrainMap& grains) {
  if (grains.line < 0) return;
  const Raster<std::int32_t> before = map.code;
  for_each_pixel_of(before, grains.line, [&](int r, int c) {
    const Surroundings found = round_pixel(before, r, c, grains.line);
    map.code(r, c) = found.count == 1 ? found.values[0] : grains.matrix;
  });
}

}  // namespace specimen
