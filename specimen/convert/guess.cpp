#include "specimen/convert/guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unordered_map>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

/// Give each distinct value a number while they come in, and put them in order at the end.
class Collector {
 public:
  explicit Collector(int most) : most_(static_cast<std::size_t>(most)) {}

  /// @return the provisional number, or -1 when there are too many values.
  std::int32_t number_of(std::int64_t value) {
    if (!values_.empty() && value == last_value_) return last_number_;
    const auto [found, is_new] = number_.try_emplace(value, static_cast<std::int32_t>(values_.size()));
    if (is_new) values_.push_back(value);
    if (values_.size() > most_) return -1;
    last_value_ = value;
    return last_number_ = found->second;
  }

  void put_in_order(ValueMap& map) const {
    map.values = values_;
    std::sort(map.values.begin(), map.values.end());
    std::vector<std::int32_t> place(values_.size());
    for (std::size_t i = 0; i < map.values.size(); ++i)
      place[static_cast<std::size_t>(number_.at(map.values[i]))] = static_cast<std::int32_t>(i);
    for (std::int32_t& code : map.code.data) code = place[static_cast<std::size_t>(code)];
  }

 private:
  std::size_t most_;
  std::unordered_map<std::int64_t, std::int32_t> number_;
  std::vector<std::int64_t> values_;
  std::int64_t last_value_ = 0;  // neighbours are mostly alike
  std::int32_t last_number_ = 0;
};

template <class T, class Value>
std::optional<ValueMap> collect(const Raster<T>& pixels, int most, Value value_of) {
  ValueMap map;
  map.code = Raster<std::int32_t>(pixels.rows, pixels.cols);
  Collector collector(most);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::optional<std::int64_t> value = value_of(pixels.data[i]);
    if (!value) return std::nullopt;
    map.code.data[i] = collector.number_of(*value);
    if (map.code.data[i] < 0) return std::nullopt;
  }
  collector.put_in_order(map);
  return map;
}

std::optional<std::int64_t> whole_number(double v) {
  constexpr double limit = 9e15;  // beyond it doubles skip whole numbers
  if (v != std::floor(v) || std::abs(v) > limit) return std::nullopt;
  return static_cast<std::int64_t>(v);
}

}  // namespace

std::optional<ValueMap> distinct_values(const Picture& picture, int most) {
  if (!picture.indices.empty())
    return collect(picture.indices, most, [](std::uint8_t i) { return std::optional<std::int64_t>(i); });
  if (!picture.gray.empty()) return collect(picture.gray, most, whole_number);
  std::optional<ValueMap> map = collect(
      picture.colour, most, [](Rgb c) { return std::optional<std::int64_t>(c.r << 16 | c.g << 8 | c.b); });
  if (map) map->colours = true;
  return map;
}

std::string value_text(const ValueMap& map, int code) {
  const std::int64_t value = map.values[static_cast<std::size_t>(code)];
  if (!map.colours) return std::to_string(value);
  std::array<char, 8> text{};
  (void)std::snprintf(text.data(), text.size(), "#%06x", static_cast<unsigned>(value & 0xffffff));
  return text.data();
}

double coherence(const ValueMap& map) {
  if (map.code.cols < 2) return 1;
  std::int64_t alike = 0;
  for (int r = 0; r < map.code.rows; ++r)
    for (int c = 0; c + 1 < map.code.cols; ++c) alike += map.code(r, c) == map.code(r, c + 1);
  return static_cast<double>(alike) / (static_cast<double>(map.code.rows) * (map.code.cols - 1));
}

std::vector<std::int64_t> largest_pieces(const Raster<std::int32_t>& code, int count) {
  const Components pieces = connected_pieces(code, Connectivity::edges);
  std::vector<std::int64_t> largest(static_cast<std::size_t>(count), 0);
  for (std::size_t i = 0; i < code.size(); ++i) {
    std::int64_t& best = largest[static_cast<std::size_t>(code.data[i])];
    best = std::max(best, pieces.area[static_cast<std::size_t>(pieces.piece.data[i])]);
  }
  return largest;
}

namespace {

/// True when nearly every value but 0 lies in one piece, specks aside, as grains do and phases do not.
bool looks_like_grains(const ValueMap& map) {
  constexpr int least_grains = 5;
  constexpr double nearly = 0.9;
  if (map.colours || map.values.front() != 0 || map.count() - 1 < least_grains) return false;
  std::vector<std::int64_t> area(map.values.size(), 0);
  for (const std::int32_t code : map.code.data) ++area[static_cast<std::size_t>(code)];
  const std::vector<std::int64_t> largest = largest_pieces(map.code, map.count());
  int whole = 0;
  for (std::size_t i = 1; i < area.size(); ++i)
    whole += static_cast<double>(largest[i]) >= nearly * static_cast<double>(area[i]);
  return whole >= nearly * (map.count() - 1);
}

/// Pixel edges that the values of our phases share in the picture.
struct SharedEdges {
  double aggregate_mortar = 0;
  double itz = 0;  ///< with aggregate or mortar
};

SharedEdges shared_edges(const ValueMap& map) {
  SharedEdges edges;
  const auto touch = [&](std::int32_t first, std::int32_t second) {
    const std::int64_t a = map.values[static_cast<std::size_t>(std::min(first, second))];
    const std::int64_t b = map.values[static_cast<std::size_t>(std::max(first, second))];
    if (a == phase::aggregate && b == phase::mortar) ++edges.aggregate_mortar;
    if ((a == phase::aggregate || a == phase::mortar) && b == phase::itz) ++edges.itz;
  };
  for (int r = 0; r < map.code.rows; ++r)
    for (int c = 0; c < map.code.cols; ++c) {
      if (c + 1 < map.code.cols) touch(map.code(r, c), map.code(r, c + 1));
      if (r + 1 < map.code.rows) touch(map.code(r, c), map.code(r + 1, c));
    }
  return edges;
}

/// Our labels: mortar is there, and where there is ITZ it keeps aggregates and mortar apart.
bool written_by_us(const ValueMap& map) {
  if (map.colours || map.values.front() < phase::void_ || map.values.back() > phase::itz) return false;
  if (std::find(map.values.begin(), map.values.end(), phase::mortar) == map.values.end()) return false;
  const SharedEdges edges = shared_edges(map);
  return map.values.back() != phase::itz || edges.aggregate_mortar <= edges.itz;
}

/// Index of the largest from `first` on; the first among equals, so that of two classes the brighter is
/// aggregate.
std::size_t largest_from(const std::vector<std::int64_t>& areas, std::size_t first) {
  std::size_t best = first;
  for (std::size_t i = first; i < areas.size(); ++i)
    if (areas[i] > areas[best]) best = i;
  return best;
}

}  // namespace

Segmentation guess_method(const std::optional<ValueMap>& map) {
  constexpr int surely_labels = 8;
  constexpr double coherent = 0.8;
  if (map && coherence(*map) >= coherent && looks_like_grains(*map)) return Segmentation::instances;
  if (map && map->count() <= surely_labels) return Segmentation::labels;
  if (map && map->count() <= most_labels && coherence(*map) >= coherent) return Segmentation::labels;
  return Segmentation::kmeans;
}

std::vector<std::string> guess_label_phases(const ValueMap& map) {
  std::vector<std::string> phases;
  if (written_by_us(map)) {
    for (const std::int64_t value : map.values)
      phases.push_back(standard_phases()[static_cast<std::size_t>(value)]);
    return phases;
  }
  const std::size_t matrix = largest_from(largest_pieces(map.code, map.count()), 0);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const bool nothing = map.values[i] == 0 || (map.values[i] == 255 && !map.colours);
    phases.emplace_back(i == matrix ? "mortar" : nothing && map.count() > 2 ? "void" : "aggregate");
  }
  return phases;
}

std::vector<std::string> guess_class_phases(const Raster<std::uint8_t>& classes, int count, bool has_void) {
  Raster<std::int32_t> code(classes.rows, classes.cols);
  std::copy(classes.data.begin(), classes.data.end(), code.data.begin());
  const bool void_first = has_void && count >= 3;
  const std::size_t matrix = largest_from(largest_pieces(code, count), void_first ? 1 : 0);
  std::vector<std::string> phases;
  for (int i = 0; i < count; ++i)
    phases.emplace_back(static_cast<std::size_t>(i) == matrix ? "mortar"
                        : i == 0 && void_first                ? "void"
                                                              : "aggregate");
  return phases;
}

}  // namespace specimen
