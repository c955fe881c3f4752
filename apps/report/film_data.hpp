/// What the film of a report is drawn from: no frames, but when and how each pixel failed.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "apps/run/run_folder.hpp"

namespace output {

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

}  // namespace output
