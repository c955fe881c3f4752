#include "specimen/convert/values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unordered_map>

#include "specimen/body/components.hpp"

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

}  // namespace specimen
