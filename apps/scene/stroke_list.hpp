/// Strokes that show the phases of a picture, as lines in a file.
#pragma once

#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"

namespace app {

/// Whether a file of strokes holds lines (.csv, .geojson, .json), not a picture, by its name.
[[nodiscard]] bool holds_lines(const std::string& path);

/// Read strokes along lines. x counts pixels from the left and y from the top of the picture.
/// - CSV: the columns stroke (a number or a word of its own for each), phase, x_px, y_px and, if wanted,
///   width_px (3 if missing); each row is a point of its stroke.
/// - GeoJSON: features with a LineString, a MultiLineString, a Point or a MultiPoint. Their property "phase",
///   or the name of their "classification" as QuPath writes it, is the phase; "width" is in pixels.
/// The phase "cut" parts aggregates that touch, "one-grain" makes one aggregate of all that a stroke crosses.
/// @throws Rejected with every mistake and its place.
[[nodiscard]] std::vector<specimen::StrokeLine> read_stroke_list(const std::string& path);

/// The same from text; `path` is for the messages, and its ending tells the form.
[[nodiscard]] std::vector<specimen::StrokeLine> parse_stroke_list(const std::string& text,
                                                                  const std::string& path);

/// Strokes as CSV, which read_stroke_list() reads as the same lines.
[[nodiscard]] std::string stroke_list_text(const std::vector<specimen::StrokeLine>& lines);

}  // namespace app
