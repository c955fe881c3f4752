#include "specimen/convert/outside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "specimen/convert/levels.hpp"

namespace specimen {
namespace {

using Place = std::pair<int, int>;

template <class T>
std::array<Place, 4> corners_of(const Raster<T>& code) {
  return {{{0, 0}, {0, code.cols - 1}, {code.rows - 1, 0}, {code.rows - 1, code.cols - 1}}};
}

/// Mark the piece of equal code that a place belongs to, a run of a row at a time: few are ever open.
template <class T>
void flood(const Raster<T>& code, Place start, OutsideMask& marked) {
  const T value = code(start.first, start.second);
  std::vector<Place> open{start};
  const auto is_open = [&](int r, int c) { return code(r, c) == value && marked(r, c) == 0; };
  while (!open.empty()) {
    const auto [r, c] = open.back();
    open.pop_back();
    if (!is_open(r, c)) continue;
    int first = c, last = c;
    while (first > 0 && is_open(r, first - 1)) --first;
    while (last + 1 < code.cols && is_open(r, last + 1)) ++last;
    std::fill(&marked(r, first), &marked(r, first) + (last - first + 1), std::uint8_t{1});
    for (const int row : {r - 1, r + 1}) {
      if (row < 0 || row >= code.rows) continue;
      for (int col = first; col <= last; ++col)
        if (is_open(row, col) && (col == first || !is_open(row, col - 1))) open.emplace_back(row, col);
    }
  }
}

double cross(Place o, Place a, Place b) {
  return double(a.second - o.second) * (b.first - o.first) -
         double(a.first - o.first) * (b.second - o.second);
}

/// Area of the convex hull of the pixels that are not marked [px]; Andrew's monotone chain.
double hull_area(const OutsideMask& marked) {
  std::vector<Place> ends;  // first and last pixel of each row, as corners of the pixels
  for (int r = 0; r < marked.rows; ++r) {
    int first = -1, last = -1;
    for (int c = 0; c < marked.cols; ++c)
      if (marked(r, c) == 0) {
        if (first < 0) first = c;
        last = c;
      }
    if (first < 0) continue;
    for (const int row : {r, r + 1}) ends.emplace_back(row, first), ends.emplace_back(row, last + 1);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Place> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Place& p : ends) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(ends.begin(), ends.end());
  }
  double area = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto [r, c] = hull[i];
    const auto [s, d] = hull[(i + 1) % hull.size()];
    area += (double(c) * s - double(d) * r) / 2;
  }
  return std::abs(area);
}

/// Value at the most corners, and at how many.
template <class T>
std::pair<std::int32_t, int> commonest_corner(const Raster<T>& code) {
  std::pair<std::int32_t, int> best{-1, 0};
  for (const auto& [r, c] : corners_of(code)) {
    const std::int32_t value = code(r, c);
    if (value < 0) continue;
    int alike = 0;
    for (const auto& [row, col] : corners_of(code)) alike += code(row, col) == code(r, c);
    if (alike > best.second) best = {value, alike};
  }
  return best;
}

template <class T>
OutsideMask corner_pieces(const Raster<T>& code, std::int32_t value) {
  OutsideMask marked(code.rows, code.cols, 0);
  for (const Place& corner : corners_of(code))
    if (code(corner.first, corner.second) == value) flood(code, corner, marked);
  return marked;
}

/// Whether what is not marked is convex: a body, and no heap of stones in a matrix.
bool is_body(const OutsideMask& marked) {
  constexpr double convex = 0.93, least_share = 0.005;
  const auto outside = static_cast<double>(std::count(marked.data.begin(), marked.data.end(), 1));
  const double body = static_cast<double>(marked.size()) - outside;
  if (body <= 0 || outside < least_share * static_cast<double>(marked.size())) return false;
  return body > convex * hull_area(marked);
}

double border_share(const OutsideMask& marked) {
  double along = 0;
  for (int c = 0; c < marked.cols; ++c) along += marked(0, c) + marked(marked.rows - 1, c);
  for (int r = 0; r < marked.rows; ++r) along += marked(r, 0) + marked(r, marked.cols - 1);
  return along / (2.0 * (marked.rows + marked.cols));
}

/// Whether it takes much of the border of the picture, as stones at the corners do not; or all corners, and
/// has no other pieces.
template <class T>
bool is_round_about(const Raster<T>& code, const OutsideMask& marked, int corners) {
  constexpr double much = 0.25, some = 0.08, few = 0.02;
  const double share = border_share(marked);
  if (share >= much) return true;
  if (corners < 4 || share < some) return false;
  const std::int32_t value = code(0, 0);  // as at all corners
  double elsewhere = 0, outside = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    outside += marked.data[i];
    elsewhere += marked.data[i] == 0 && code.data[i] == value;
  }
  return elsewhere < few * static_cast<double>(code.size()) && elsewhere < outside;
}

/// Whether there are two values or more, with more than specks of each, in what is not marked.
bool has_structure(const Raster<std::int32_t>& code, const OutsideMask& marked) {
  std::vector<std::pair<std::int32_t, double>> found;
  double all = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (marked.data[i] != 0) continue;
    ++all;
    auto place =
        std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == code.data[i]; });
    if (place == found.end()) {
      if (found.size() > 64) return true;
      place = found.insert(found.end(), {code.data[i], 0});
    }
    ++place->second;
  }
  return std::count_if(found.begin(), found.end(), [&](const auto& f) { return f.second > 0.002 * all; }) >=
         2;
}

}  // namespace

OutsideMask outside_of_map(const Raster<std::int32_t>& code, bool forced, int black) {
  const auto [value, corners] = commonest_corner(code);
  if (corners == 0 || (!forced && corners < (value == black ? 2 : 3))) return {};
  OutsideMask marked = corner_pieces(code, value);
  if (!forced && (!is_round_about(code, marked, corners) || !is_body(marked) || !has_structure(code, marked)))
    return {};
  return marked;
}

OutsideMask without_value(const Picture& picture) {
  OutsideMask marked;
  const auto mark = [&](std::size_t i) {
    if (marked.empty()) marked = OutsideMask(picture.rows(), picture.cols(), 0);
    marked.data[i] = 1;
  };
  for (std::size_t i = 0; i < picture.opacity.size(); ++i)
    if (picture.opacity.data[i] < 128) mark(i);
  picture.gray.data.visit([&](const auto& values) {
    if constexpr (std::is_floating_point_v<typename std::decay_t<decltype(values)>::value_type>)
      for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isnan(values[i])) mark(i);
  });
  return marked;
}

OutsideMask outside_of_photograph(const Picture& picture, bool forced) {
  if (OutsideMask marked = without_value(picture); !marked.empty()) return marked;
  const Raster<Rgb> grey = picture.gray.empty() ? Raster<Rgb>() : shown_colours(picture);
  const Raster<Rgb>& colours = picture.gray.empty() ? picture.colour : grey;
  const int dark = picture.lossy ? 20 : 6, light = 255 - dark;
  const Rgb corner = colours(0, 0);
  Raster<std::uint8_t> code(colours.rows, colours.cols);
  std::transform(colours.data.begin(), colours.data.end(), code.data.begin(), [&](Rgb c) -> std::uint8_t {
    if (std::max({c.r, c.g, c.b}) <= dark) return 0;
    if (std::min({c.r, c.g, c.b}) >= light) return 1;
    if (forced &&
        std::max({std::abs(c.r - corner.r), std::abs(c.g - corner.g), std::abs(c.b - corner.b)}) <= 24)
      return 2;
    return 3;
  });
  const auto [value, corners] = commonest_corner(code);
  if (value == 3 || corners == 0 || (!forced && corners < 2)) return {};
  OutsideMask marked = corner_pieces(code, value);
  return forced || (is_round_about(code, marked, corners) && is_body(marked)) ? marked : OutsideMask();
}

}  // namespace specimen
