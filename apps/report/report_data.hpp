/// What the script of a report reads, and draws charts and the film from.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/report/run_record.hpp"

namespace output {

/// In the zlib format, which browsers call "deflate", as base64.
/// @throws std::runtime_error when there is no memory for it.
[[nodiscard]] std::string deflated_base64(std::string_view bytes);

/// The bytes of an array as they lie in memory.   @pre the machine is little-endian, as the page expects.
template <class T>
[[nodiscard]] std::string deflated_base64(std::span<const T> values) {
  return deflated_base64(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
}

/// {title, x, y, series, markers, references}: axes {label, logarithmic}, series {name, ink, dashed, x, y}.
/// Numbers have seven digits; one that is not finite is null, and leaves a gap.
/// @param references  curves to switch on.
[[nodiscard]] nlohmann::ordered_json chart_json(const Chart& chart,
                                                const std::vector<Series>& references = {});

/// JSON without any of < > &, so that it cannot end the element of a page that holds it; bytes that are no
/// UTF-8 become U+FFFD.
[[nodiscard]] std::string inert_text(const nlohmann::ordered_json& json);

/// Pixels up to which a page carries a film, and the strength of each pixel.
inline constexpr std::int64_t most_film_pixels = 4'000'000;
inline constexpr std::int64_t most_strength_pixels = 500'000;

[[nodiscard]] bool has_film(const RunRecord& record);

/// Keys: rows, cols, pixel_mm, end_strain; phases[label] {name, colour, grey, tensile_MPa, cohesion_MPa},
/// null for a phase that cannot fail so; tension and shear {colour, grey}; labels and mode (uint8), failure
/// and crush (float32, NaN = never; crush null without crack closure) and strength (uint16, in units of
/// strength_unit: the factor on the strengths of the pixel; null where there is none), each of shape (rows,
/// cols) from the top row down, deflated, as base64.   @pre has_film(record)
[[nodiscard]] nlohmann::ordered_json film_data(const RunRecord& record);

/// Of these what changes while a run goes on: end_strain, failure, mode, crush.   @pre has_film(record)
[[nodiscard]] nlohmann::ordered_json film_growth(const RunRecord& record);

/// JSON without any of < > &, so that it cannot end the element that holds it. Keys: strain {name,
/// per_strain}, csv (curve.csv, deflated, as base64), charts by id, each {title, x, y, series, markers,
/// references}, film (see film_data; null for none). A run that goes on has no csv yet: null.
[[nodiscard]] std::string report_data(const RunRecord& record);

[[nodiscard]] nlohmann::ordered_json strain_json(const RunRecord& record);    ///< its key "strain"
[[nodiscard]] nlohmann::ordered_json charts_of_run(const RunRecord& record);  ///< charts without the sieve

}  // namespace output
