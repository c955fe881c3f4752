#include "apps/drawing/thin_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace output {
namespace {

/// Half a pixel wide, for renderers that draw at twice the size.
double column_of(const Place& place) { return std::floor(2 * place.x); }

/// Keep what can be seen of places [begin, end), which lie in one column.
void keep_extremes(const std::vector<Place>& places, std::size_t begin, std::size_t end,
                   std::vector<Place>& kept) {
  const auto first = places.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = places.begin() + static_cast<std::ptrdiff_t>(end);
  const auto [low, high] =
      std::minmax_element(first, last, [](const Place& a, const Place& b) { return a.y < b.y; });
  std::array indices{first, low, high, last - 1};
  std::sort(indices.begin(), indices.end());
  const auto distinct = std::unique(indices.begin(), indices.end());
  for (auto it = indices.begin(); it != distinct; ++it) kept.push_back(**it);
}

}  // namespace

std::vector<std::vector<Place>> unbroken_lines(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::vector<Place>> lines(1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
      lines.back().push_back({x[i], y[i]});
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  std::erase_if(lines, [](const std::vector<Place>& line) { return line.size() < 2; });
  return lines;
}

std::vector<Place> thin_line(const std::vector<Place>& places) {
  std::vector<Place> kept;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= places.size(); ++i)
    if (i == places.size() || column_of(places[i]) != column_of(places[begin])) {
      keep_extremes(places, begin, i, kept);
      begin = i;
    }
  return kept;
}

}  // namespace output
