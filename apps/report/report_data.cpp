#include "apps/report/report_data.hpp"

#include <zlib.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <vector>

#include "apps/drawing/colours.hpp"
#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/reference_curves.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "libmpm/material/strength.hpp"

namespace output {

static_assert(std::endian::native == std::endian::little);

std::string deflated_base64(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, from, bytes.size(), Z_DEFAULT_COMPRESSION) !=
      Z_OK)
    throw std::runtime_error("no memory to compress what the page shows");
  packed.resize(size);
  return base64(packed);
}

namespace {

using Json = nlohmann::ordered_json;

Json shown(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  const double scale = std::pow(10, 6 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(shown(value));
  return list;
}

Json axis_json(const Axis& axis) {
  return {{"label", axis.unit.empty() ? axis.label : axis.label + " [" + axis.unit + "]"},
          {"logarithmic", axis.logarithmic}};
}

Json series_json(const std::vector<Series>& list) {
  Json all = Json::array();
  for (const Series& series : list)
    all.push_back({{"name", series.name},
                   {"ink", name_of(series.ink)},
                   {"dashed", series.dashed},
                   {"x", numbers(series.x)},
                   {"y", numbers(series.y)}});
  return all;
}

Json markers_json(const std::vector<Marker>& markers) {
  Json all = Json::array();
  for (const Marker& marker : markers)
    all.push_back({{"x", shown(marker.x)}, {"y", shown(marker.y)}, {"text", marker.text}});
  return all;
}

}  // namespace

Json chart_json(const Chart& chart, const std::vector<Series>& references) {
  return {{"title", chart.title},
          {"x", axis_json(chart.x)},
          {"y", axis_json(chart.y)},
          {"series", series_json(chart.series)},
          {"markers", markers_json(chart.markers)},
          {"references", series_json(references)}};
}

std::string inert_text(const Json& json) {
  const std::string written = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(written.size());
  for (const char c : written) switch (c) {
      case '<':
        text += "\\u003c";
        break;
      case '>':
        text += "\\u003e";
        break;
      case '&':
        text += "\\u0026";
        break;
      default:
        text += c;
    }
  return text;
}

namespace {

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
Json packed(const mpm::PixelField<T>& map) {
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
         largest_strain(record.result) > 0;
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
  return {{"end_strain", largest_strain(result)},
          {"failure", packed(result.failure_strain)},
          {"mode", packed(result.failure_mode)},
          {"crush", result.crush_strain.size() > 0 ? packed(result.crush_strain) : Json(nullptr)}};
}

Json strain_json(const RunRecord& record) {
  const StrainUnit unit = strain_unit(record.result);
  return {{"name", unit.name}, {"per_strain", unit.per_strain}};
}

namespace {

/// The script draws what there is: a fault here is told by the section that shows the same.
template <class Make>
void add_standing(Json& all, const char* name, const Make& make) {
  try {
    all[name] = make();
  } catch (const std::exception&) {
    all.erase(name);
  }
}

}  // namespace

Json charts_of_run(const RunRecord& record) {
  Json charts = Json::object();
  add_standing(charts, "stress", [&] { return chart_json(stress_chart(record), reference_series(record)); });
  add_standing(charts, "energy", [&] { return chart_json(energy_chart(record)); });
  add_standing(charts, "failure", [&] { return chart_json(failure_chart(record)); });
  add_standing(charts, "failure-strain", [&] { return chart_json(failure_strain_chart(record)); });
  return charts;
}

std::string report_data(const RunRecord& record) {
  Json charts = charts_of_run(record);
  add_standing(charts, "sieve",
               [&] { return chart_json(sieve_chart(record.specimen), sieve_references(record.specimen)); });
  const Json csv = record.goes_on ? Json(nullptr) : Json(deflated_base64(curve_csv(record)));
  Json all{{"strain", strain_json(record)}, {"csv", csv}, {"charts", std::move(charts)}, {"film", nullptr}};
  if (has_film(record)) add_standing(all, "film", [&] { return film_data(record); });
  if (!all.contains("film")) all["film"] = nullptr;
  return inert_text(all);
}

}  // namespace output
