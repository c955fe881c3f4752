/// Maps of labels, grains and colours: whether a picture is one, and the phase of each of its pixels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/convert/guess.hpp"
#include "specimen/convert/segment.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Whether a method takes the values of the picture for what they are.
[[nodiscard]] bool is_map_method(Segmentation method);

/// The map that a picture is, its soft edges settled; nothing for a photograph.
/// @throws Error for a JPEG of label numbers.
[[nodiscard]] std::optional<ValueMap> map_of(const Picture& picture, const ConvertOptions& options,
                                             ConvertReport& report);

/// The map, if it is one.   @throws Error for a photograph and for too many values.
[[nodiscard]] ValueMap require_values(std::optional<ValueMap> map, int most, const char* what);

/// Whether the colours are those that a preview has: mortar and at least one more, and no other.
[[nodiscard]] bool has_our_colours(const ValueMap& map);

/// Read a file of this program by its own numbers or colours.
/// @return nothing where it has been painted over in values of no phase.
[[nodiscard]] std::optional<Sorted> segment_own(const Picture& picture, ConvertReport& report);

/// Phases as the options say, or as they are read.   @throws TwoReadings; Error for options that do not fit.
[[nodiscard]] Sorted segment_labels(ValueMap map, Picture picture, const ConvertOptions& o,
                                    ConvertReport& report);
[[nodiscard]] Sorted segment_instances(ValueMap map, Picture picture, const ConvertOptions& o,
                                       ConvertReport& report);

/// Put each pixel in its phase; aggregates of different values stay apart even where they touch.
void fill_cells(Sorted& sorted, Raster<std::int32_t> code, const std::vector<std::string>& phases);

/// Say how much of a picture is taken for its outside.
void note_outside(double pixels, double all, const std::string& what, ConvertReport& report);

}  // namespace specimen
