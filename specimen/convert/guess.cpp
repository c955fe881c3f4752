#include "specimen/convert/guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "specimen/body/mask.hpp"
#include "specimen/convert/instances.hpp"
#include "specimen/convert/levels.hpp"
#include "specimen/convert/shapes.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {
namespace {

/// Give each distinct value a number while they come in, and put them in order at the end.
class Collector {
 public:
  explicit Collector(int most) : most_(static_cast<std::size_t>(most)) {}

  /// @return the provisional number, or -1 when there are too many values.
  std::int32_t number_of(std::int64_t value) {
    ++seen_;
    if (!values_.empty() && value == last_value_) return last_number_;
    ++changes_;
    const auto [found, is_new] = number_.try_emplace(value, static_cast<std::int32_t>(values_.size()));
    if (is_new) values_.push_back(value);
    if (values_.size() > most_ || (is_new && is_noise())) return -1;
    last_value_ = value;
    return last_number_ = found->second;
  }

  /// Whether most pixels of many differ from the one before them: noise, and no map.
  [[nodiscard]] bool is_noise() const {
    constexpr std::size_t many = 4096;
    return values_.size() > many && 2 * changes_ > seen_;
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
  std::int64_t seen_ = 0, changes_ = 0;
};

/// @param value_of  of each of the pixels, row by row; nothing for one that is no whole number.
template <class T, class Value>
std::optional<ValueMap> collect(int rows, int cols, const std::vector<T>& pixels, int most, Value value_of) {
  ValueMap map;
  map.code = Raster<std::int32_t>(rows, cols);
  Collector collector(most);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::optional<std::int64_t> value = value_of(pixels[i]);
    if (!value) return std::nullopt;
    map.code.data[i] = collector.number_of(*value);
    if (map.code.data[i] < 0) return std::nullopt;
  }
  collector.put_in_order(map);
  return map;
}

std::optional<std::int64_t> whole_number(double v) {
  constexpr double limit = 9e15;  // beyond it doubles skip whole numbers
  if (std::isnan(v)) return no_number;
  if (v != std::floor(v) || std::abs(v) > limit) return std::nullopt;
  return static_cast<std::int64_t>(v);
}

}  // namespace

int blackest(const ValueMap& map) {
  if (map.values.empty()) return -1;
  if (!map.colours) return map.values.front() == no_number && map.count() > 1 ? 1 : 0;
  const auto luma = [&](std::int64_t v) {
    const auto channel = [&](int shift) { return static_cast<double>(v >> shift & 255); };
    return 0.3 * channel(16) + 0.6 * channel(8) + 0.1 * channel(0);
  };
  const auto least = std::min_element(map.values.begin(), map.values.end(),
                                      [&](std::int64_t x, std::int64_t y) { return luma(x) < luma(y); });
  constexpr double black = 40;
  return luma(*least) < black ? static_cast<int>(least - map.values.begin()) : -1;
}

namespace {

std::int64_t number_of(Rgb c) { return c.r << 16 | c.g << 8 | c.b; }

/// What each index of a palette shows, grey value or colour; nothing for those that are not used.
std::array<std::optional<std::int64_t>, 256> shown_by(const Picture& picture) {
  std::array<std::optional<std::int64_t>, 256> shown{};
  const bool coloured = is_coloured(picture);
  for (std::size_t i = 0; i < picture.indices.size(); ++i) {
    auto& value = shown[picture.indices.data[i]];
    if (!value)
      value = coloured ? number_of(picture.colour.data[i]) : static_cast<std::int64_t>(gray_at(picture, i));
  }
  return shown;
}

/// The black one among indices into a palette, by what they show.
int blackest_of_palette(const Picture& picture, const ValueMap& map) {
  const auto by_index = shown_by(picture);
  ValueMap shown;
  shown.colours = is_coloured(picture);
  for (const std::int64_t index : map.values)
    shown.values.push_back(*by_index[static_cast<std::size_t>(index)]);
  if (shown.colours) return blackest(shown);
  return static_cast<int>(std::min_element(shown.values.begin(), shown.values.end()) - shown.values.begin());
}

std::optional<ValueMap> palette_indices(const Picture& picture, int most) {
  std::optional<ValueMap> map = collect(picture.rows(), picture.cols(), picture.indices.data, most,
                                        [](std::uint8_t i) { return std::optional<std::int64_t>(i); });
  if (map) map->black = blackest_of_palette(picture, *map);
  return map;
}

}  // namespace

bool shares_colours(const Picture& picture) {
  std::vector<std::int64_t> values;
  for (const auto& value : shown_by(picture))
    if (value) values.push_back(*value);
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

std::map<std::int64_t, std::int64_t> names_by_palette(const Picture& picture) {
  if (!picture.names.empty()) return picture.names;
  std::map<std::int64_t, std::int64_t> names;
  if (picture.indices.empty() || shares_colours(picture)) return names;
  const auto shown = shown_by(picture);
  for (std::size_t index = 0; index < shown.size(); ++index)
    if (shown[index]) names[*shown[index]] = static_cast<std::int64_t>(index);
  return names;
}

void name_by_palette(ValueMap& map, const Picture& picture) {
  const std::map<std::int64_t, std::int64_t> known = names_by_palette(picture);
  std::vector<std::int64_t> names;
  for (const std::int64_t value : map.values) {
    const auto name = known.find(value);
    if (name == known.end()) return;
    names.push_back(name->second);
  }
  map.names = std::move(names);
}

std::optional<ValueMap> distinct_values(const Picture& picture, int most, Palette palette) {
  if (palette == Palette::indices && shares_colours(picture)) return palette_indices(picture, most);
  std::optional<ValueMap> map;
  const bool coloured = is_coloured(picture);
  const auto collected = [&](const auto& pixels, const auto& value_of) {
    return collect(picture.rows(), picture.cols(), pixels, most, value_of);
  };
  if (!picture.gray.empty())
    map = picture.gray.data.visit([&](const auto& values) {
      return collected(values, [](auto v) { return whole_number(static_cast<double>(v)); });
    });
  else if (coloured)
    map = collected(picture.colour.data, [](Rgb c) { return std::optional(number_of(c)); });
  else
    map = collected(picture.colour.data, [](Rgb c) { return std::optional<std::int64_t>(c.r); });
  if (!map) return map;
  map->colours = coloured;
  map->black = blackest(*map);
  name_by_palette(*map, picture);
  return map;
}

std::string value_text(const ValueMap& map, int code) {
  const std::int64_t value = map.values[static_cast<std::size_t>(code)];
  if (!map.names.empty()) return std::to_string(map.names[static_cast<std::size_t>(code)]);
  if (value == no_number) return "NaN";
  if (!map.colours) return std::to_string(value);
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(value >> shift & 255); };
  return colour_text({byte(16), byte(8), byte(0)});
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
    if (code.data[i] < 0) continue;
    std::int64_t& best = largest[static_cast<std::size_t>(code.data[i])];
    best = std::max(best, pieces.area[static_cast<std::size_t>(pieces.piece.data[i])]);
  }
  return largest;
}

namespace {

/// Index of the largest from `first` on; the first among equals, so that of two classes the brighter is
/// aggregate.
std::size_t largest_from(const std::vector<std::int64_t>& areas, std::size_t first) {
  std::size_t best = first;
  for (std::size_t i = first; i < areas.size(); ++i)
    if (areas[i] > areas[best]) best = i;
  return best;
}

}  // namespace

namespace {

/// Whether a map has a colour or number for each grain that other grains share: one value lies between most
/// of the others, and nearly every pixel is like its neighbour.
bool repeats_colours(const ValueMap& map) {
  constexpr double coherent = 0.9, most_others = 0.6;
  if (map.count() > most_in_contact || coherence(map) < coherent) return false;
  const std::vector<int> neighbours = neighbours_of(map.code, map.count());
  return *std::max_element(neighbours.begin(), neighbours.end()) >= most_others * (map.count() - 1);
}

}  // namespace

Segmentation guess_method(const std::optional<ValueMap>& map) {
  constexpr int surely_labels = 8;
  constexpr double coherent = 0.8, fairly_coherent = 0.5;  // small grains with lines between them
  if (map && coherence(*map) >= fairly_coherent && looks_like_grains(*map)) return Segmentation::instances;
  if (map && map->count() <= surely_labels) return Segmentation::labels;
  if (map && map->count() <= most_labels && coherence(*map) >= coherent) return Segmentation::labels;
  if (map && repeats_colours(*map)) return Segmentation::labels;
  return Segmentation::kmeans;
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
