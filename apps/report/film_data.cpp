#include "apps/report/film_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "apps/drawing/damage_picture.hpp"
#include "apps/report/deflate.hpp"
#include "apps/drawing/ink.hpp"
#include "apps/report/run_words.hpp"
#include "libmpm/material/strength_field.hpp"

namespace output {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t pixels_of(const RunRecord& record) {
  return static_cast<std::int64_t>(record.specimen.mask.labels.data.size());
}

Json looks(specimen::Rgb colour, specimen::Rgb grey) {
  return {{"colour", hex(colour)}, {"grey", hex(grey)}};
}

Json strength_in_mpa(double strength) {
  return std::isfinite(strength) ? Json(1e-6 * strength) : Json(nullptr);
}

/// nullptr = a void.
const mpm::Phase* solid_of(const mpm::Scene& scene, std::size_t label) {
  return label < scene.phases.size() && scene.phases[label] ? &*scene.phases[label] : nullptr;
}

Json phases_of(const RunRecord& record, const Palette& colour, const Palette& grey) {
  Json phases = Json::array();
  for (std::size_t label = 0; label < record.specimen.mask.phases.size(); ++label) {
    Json phase = {{"name", phase_word(record.specimen.mask.phases[label])}};
    phase.update(looks(colour.phases[label], grey.phases[label]));
    const mpm::Phase* solid = solid_of(record.scene, label);
    phase["tensile_MPa"] = strength_in_mpa(solid != nullptr ? solid->tensile_scale : mpm::Phase::unbreakable);
    phase["cohesion_MPa"] = strength_in_mpa(solid != nullptr ? solid->cohesion : mpm::Phase::unbreakable);
    phases.push_back(std::move(phase));
  }
  return phases;
}

template <class T>
Json packed(const mpm::Lattice<T>& map) {
  return deflated_base64(std::span<const T>(map.data(), static_cast<std::size_t>(map.size())));
}

/// Sixteen bits a factor: the largest is the last of them.
void add_strengths(const RunRecord& record, Json& film) {
  film["strength"] = nullptr;
  film["strength_unit"] = nullptr;
  if (pixels_of(record) > most_strength_pixels) return;
  const mpm::StrengthFactors factors(record.scene, false);
  std::vector<double> values;
  for (int row = 0; row < static_cast<int>(record.scene.labels.rows()); ++row)
    for (int col = 0; col < static_cast<int>(record.scene.labels.cols()); ++col) {
      const mpm::Phase* phase = solid_of(record.scene, record.scene.labels(row, col));
      values.push_back(phase != nullptr && phase->can_fail() ? factors.of_pixel(row, col) : 0);
    }
  const double largest = *std::max_element(values.begin(), values.end());
  if (!(largest > 0)) return;
  const double unit = largest / std::numeric_limits<std::uint16_t>::max();
  std::vector<std::uint16_t> steps(values.size());
  std::transform(values.begin(), values.end(), steps.begin(),
                 [unit](double value) { return static_cast<std::uint16_t>(std::lround(value / unit)); });
  film["strength"] = deflated_base64(std::span<const std::uint16_t>(steps));
  film["strength_unit"] = unit;
}

}  // namespace

bool has_film(const RunRecord& record) {
  return pixels_of(record) <= most_film_pixels && record.result.failure_strain.size() == pixels_of(record) &&
         !record.result.history.empty() && record.result.history.back().strain > 0;
}

Json film_data(const RunRecord& record) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  const Palette colour = colour_palette();
  const Palette grey = grey_palette();
  Json film = {{"rows", mask.labels.rows},
               {"cols", mask.labels.cols},
               {"pixel_mm", 1e3 * mask.pixel_size},
               {"phases", phases_of(record, colour, grey)},
               {"tension", looks(colour.tension, grey.tension)},
               {"shear", looks(colour.shear, grey.shear)},
               {"labels", deflated_base64(std::span<const std::uint8_t>(mask.labels.data))}};
  film.update(film_growth(record));
  add_strengths(record, film);
  return film;
}

Json film_growth(const RunRecord& record) {
  const mpm::Result& result = record.result;
  return {{"end_strain", result.history.back().strain},
          {"failure", packed(result.failure_strain)},
          {"mode", packed(result.failure_mode)},
          {"crush", result.crush_strain.size() > 0 ? packed(result.crush_strain) : Json(nullptr)}};
}

}  // namespace output
