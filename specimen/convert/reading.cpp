#include "specimen/convert/reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace specimen {
namespace {

using Names = std::vector<std::string>;
constexpr std::size_t nobody = static_cast<std::size_t>(-1);

/// Whether a value is a thin band that keeps two others apart, which hardly touch each other without it.
bool is_band(const Shapes& shapes, std::size_t v) {
  constexpr double thin = 6, side = 0.25, leak = 0.15;  // [px], [-], [-]
  const ValueShape& shape = shapes.of[v];
  if (shape.area == 0 || shape.thickness() > thin || shapes.of.size() < 3) return false;
  std::vector<std::pair<double, int>> met;
  for (int u = 0; u < shapes.contact.cols; ++u) met.emplace_back(shapes.contact(static_cast<int>(v), u), u);
  std::partial_sort(met.begin(), met.begin() + 2, met.end(), std::greater<>());
  const auto [most, first] = met[0];
  const auto [less, second] = met[1];
  return most + less > 0.7 * shape.perimeter && less > side * shape.perimeter &&
         shapes.contact(first, second) < leak * less &&
         shapes.of[static_cast<std::size_t>(first)].thickness() > 1.5 * shape.thickness() &&
         shapes.of[static_cast<std::size_t>(second)].thickness() > 1.5 * shape.thickness();
}

/// How much a value looks like the matrix: its largest piece is part of the boundaries, and of the border.
double as_matrix(const ValueShape& shape) { return shape.reach + 0.5 * shape.border; }

std::vector<std::size_t> by_matrix(const Shapes& shapes, const std::vector<bool>& band) {
  std::vector<std::size_t> order;
  for (std::size_t v = 0; v < shapes.of.size(); ++v)
    if (!band[v] && shapes.of[v].area > 0) order.push_back(v);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double x = as_matrix(shapes.of[a]), y = as_matrix(shapes.of[b]);
    return x != y ? x > y : shapes.of[a].largest > shapes.of[b].largest;
  });
  return order;
}

/// Evidence that one of the values beside the matrix is void [-]: small pieces, little area, black.
double as_void(const ValueShape& shape, const ValueShape& stones, double whole, bool black) {
  const double smaller = std::clamp(std::log(stones.typical / shape.typical) / std::log(5.0), 0.0, 2.0);
  const bool little = shape.area < 0.1 * whole && shape.area < 0.5 * stones.area;
  return smaller + (little ? 0.5 : 0) + (black ? 1 : 0);
}

/// The value that is void among those beside the matrix, and how sure that is: below 0 there is none.
struct Void {
  std::size_t value = nobody;
  double margin = -1;
};

Void find_void(const ValueMap& map, const Shapes& shapes, const std::vector<std::size_t>& others) {
  constexpr double enough = 1.25, least_lead = 0.6;
  std::size_t stones = others.front();
  double whole = 0;
  for (const ValueShape& shape : shapes.of) whole += shape.area;
  for (const std::size_t v : others)
    if (map.outside != static_cast<int>(v) &&
        (map.outside == static_cast<int>(stones) || shapes.of[v].typical > shapes.of[stones].typical))
      stones = v;
  Void best;
  double first = 0, second = 0;
  for (const std::size_t v : others) {
    if (v == stones) continue;
    // Black stones beside small light dots speak for another order than that of grey levels.
    const double against = map.black == static_cast<int>(stones) ? 0.4 : 0;
    const double evidence =
        as_void(shapes.of[v], shapes.of[stones], whole, map.black == static_cast<int>(v)) - against +
        (map.outside == static_cast<int>(v) ? 2 : 0);
    if (evidence > first) {
      second = std::exchange(first, evidence);
      best.value = v;
    } else {
      second = std::max(second, evidence);
    }
  }
  best.margin = first - enough;
  // Several small values: one of them alone may be void, and only where it stands out; of several colours,
  // black.
  const bool is_black = best.value != nobody && map.black == static_cast<int>(best.value);
  const bool stands_out = others.size() <= 3 || first - second >= least_lead;
  if (!is_black && (!stands_out || (map.colours && others.size() > 2))) best.margin = -1;
  return best;
}

Names phases_with(std::size_t count, std::size_t matrix, std::size_t void_value,
                  const std::vector<bool>& band) {
  Names phases(count, "aggregate");
  for (std::size_t v = 0; v < count; ++v)
    if (band[v]) phases[v] = "itz";
  phases[matrix] = "mortar";
  if (void_value != nobody) phases[void_value] = "void";
  return phases;
}

/// Dots that may be pores as well as grains of sand.
bool is_a_few_dots(const ValueShape& shape, const Raster<std::int32_t>& code) {
  const double whole = static_cast<double>(code.size()), side = std::min(code.rows, code.cols);
  return shape.area < 0.02 * whole && shape.largest < 0.25 * 0.05 * side * 0.05 * side * 3.14;
}

}  // namespace

std::vector<bool> bands_of(const Shapes& shapes) {
  std::vector<bool> bands(shapes.of.size(), false);
  if (!shapes.contact.empty())
    for (std::size_t v = 0; v < bands.size(); ++v) bands[v] = is_band(shapes, v);
  return bands;
}

Reading read_map(const ValueMap& map) {
  constexpr double close_second = 0.85;
  const auto count = map.values.size();
  Reading reading;
  if (map.count() > most_in_contact) {
    reading.phases.assign(count, "aggregate");
    const std::vector<std::int64_t> largest = largest_pieces(map.code, map.count());
    reading.phases[static_cast<std::size_t>(std::max_element(largest.begin(), largest.end()) -
                                            largest.begin())] = "mortar";
    return reading;
  }
  const Shapes shapes = shapes_of(map.code, map.count());
  const std::vector<bool> band = bands_of(shapes);
  const std::vector<std::size_t> order = by_matrix(shapes, band);
  if (order.empty()) return {Names(count, "mortar"), {}, {}};
  const std::size_t matrix = order.front();
  std::vector<std::size_t> others;
  for (std::size_t v = 0; v < count; ++v)
    if (v != matrix && !band[v] && shapes.of[v].area > 0) others.push_back(v);

  Void pores;
  if (others.size() > 1) pores = find_void(map, shapes, others);
  if (others.size() == 1 && map.outside == static_cast<int>(others.front())) pores = {others.front(), 1};
  const std::size_t void_value = pores.margin > 0 ? pores.value : nobody;
  reading.phases = phases_with(count, matrix, void_value, band);
  if (order.size() > 1 && as_matrix(shapes.of[order[1]]) > close_second * as_matrix(shapes.of[matrix])) {
    reading.other = phases_with(count, order[1], void_value == order[1] ? nobody : void_value, band);
    reading.doubt = "which value is the mortar";
  } else if (pores.value != nobody && std::abs(pores.margin) < 0.3) {
    reading.other = phases_with(count, matrix, void_value == nobody ? pores.value : nobody, band);
    reading.doubt = "whether " + value_text(map, static_cast<int>(pores.value)) + " is void or aggregate";
  } else if (others.size() == 1 && void_value == nobody &&
             is_a_few_dots(shapes.of[others.front()], map.code)) {
    reading.other = phases_with(count, matrix, others.front(), band);
    reading.doubt = "whether the dots are void or aggregate";
  }
  return reading;
}

namespace {

std::string as_option(const ValueMap& map, const Names& phases) {
  std::string text;
  for (int v = 0; v < map.count(); ++v)
    text += (text.empty() ? "" : ",") + value_text(map, v) + ":" + phases[static_cast<std::size_t>(v)];
  return text;
}

}  // namespace

TwoReadings refusal_of(const ValueMap& map, const Reading& reading) {
  const std::string first = as_option(map, reading.phases), second = as_option(map, reading.other);
  TwoReadings refusal("convert.label_phases", "not given, and the map can be read in two ways",
                      "it is not clear " + reading.doubt, "give " + first + " or " + second);
  refusal.label_phases = {first, second};
  return refusal;
}

}  // namespace specimen
