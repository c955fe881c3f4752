/// The distinct values of a picture, when it is a map of labels or of grains.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "specimen/picture/picture.hpp"

namespace specimen {

/// A picture as numbers 0, 1, ... into a list of its distinct values.
struct ValueMap {
  Raster<std::int32_t> code;         ///< index into `values` per pixel
  std::vector<std::int64_t> values;  ///< rising
  bool colours = false;              ///< the values are colours, 0xRRGGBB
  [[nodiscard]] int count() const { return static_cast<int>(values.size()); }
};

/// Distinct values: palette indices where there is a palette, grey values, or colours as 0xRRGGBB.
/// @return nothing when there are more than `most` of them or a grey value is no whole number.
[[nodiscard]] std::optional<ValueMap> distinct_values(const Picture& picture, int most);

/// How a value is written for the user: 17, or #ff80ff for a colour.
[[nodiscard]] std::string value_text(const ValueMap& map, int code);

/// Share of the pixels that have the value of their right neighbour [-]: near 1 for a map, low for noise.
[[nodiscard]] double coherence(const ValueMap& map);

/// Area of the largest connected piece of each value [px].
[[nodiscard]] std::vector<std::int64_t> largest_pieces(const Raster<std::int32_t>& code, int count);

}  // namespace specimen
