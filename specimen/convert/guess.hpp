/// Guesses about a picture: its kind (labels, grains or photograph), and the phases of its values.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// A picture as indices into a list of its distinct values.
struct ValueMap {
  Raster<std::int32_t> code;         ///< index into `values` per pixel; -1 = outside of the specimen
  std::vector<std::int64_t> values;  ///< increasing
  /// What the user knows the values by, if not by themselves: the indices of a palette.
  std::vector<std::int64_t> names{};
  bool colours = false;  ///< the values are colours, 0xRRGGBB
  int black = -1;        ///< the code that is black: the lowest of the numbers, a dark colour; -1 = none
  int outside = -1;      ///< the code that lies outside of the specimen as well; -1 = none
  [[nodiscard]] int count() const { return static_cast<int>(values.size()); }
};

/// Not-a-number among the values of a map.
inline constexpr std::int64_t no_number = std::numeric_limits<std::int64_t>::min();

/// The code of the blackest of the values: numbers count as grey levels.   @return -1 where all are colours
/// and none is black.
[[nodiscard]] int blackest(const ValueMap& map);

/// How the values of a picture with a palette are told apart.
enum class Palette {
  shown,    ///< by the colours, as in any other encoding
  indices,  ///< by the indices where several of them have one colour
};

/// Distinct values: grey values, or colours as 0xRRGGBB, or as grey values where all of them are grey. A
/// palette gives them its indices as names.
/// @return nothing for more than `most` values, or if a grey value is not an integer.
[[nodiscard]] std::optional<ValueMap> distinct_values(const Picture& picture, int most,
                                                      Palette palette = Palette::shown);

/// Whether some indices of the palette that are used have the same colour.
[[nodiscard]] bool shares_colours(const Picture& picture);

/// The index of each value that a palette shows; empty without a palette, or where some show the same.
[[nodiscard]] std::map<std::int64_t, std::int64_t> names_by_palette(const Picture& picture);

/// Name the values of a map by the indices of the palette, where each of them has one.
void name_by_palette(ValueMap& map, const Picture& picture);

/// A value as shown to the user: 17, or #ff80ff for a colour.
[[nodiscard]] std::string value_text(const ValueMap& map, int code);

/// Share of the pixels that have the value of their right neighbour [-]: near 1 for a map, low for noise.
[[nodiscard]] double coherence(const ValueMap& map);

/// Area of the largest connected piece of each value [px].
[[nodiscard]] std::vector<std::int64_t> largest_pieces(const Raster<std::int32_t>& code, int count);

/// Largest number of distinct values of a picture that is taken for a map of labels by default; of a map of
/// grains.
inline constexpr int most_labels = 32;
inline constexpr int most_grains = 4'000'000;

/// Method for a picture:
/// - instances: a value between at least five others, nine in ten of them (almost) in one piece each;
/// - labels: at most eight values, or at most 32 of which 80 % of the pixels share theirs with a
///   neighbour, or at most 256 colours of grains that repeat;
/// - else kmeans.
/// @param map  the distinct values, where there are few enough.
[[nodiscard]] Segmentation guess_method(const std::optional<ValueMap>& map);

/// Phase of each class of a photograph, from the darkest to the brightest: of three or more the darkest is
/// void if `has_void`; of the others the one with the largest connected piece is mortar, the rest
/// aggregate.
[[nodiscard]] std::vector<std::string> guess_class_phases(const Raster<std::uint8_t>& classes, int count,
                                                          bool has_void);

}  // namespace specimen
