#include "apps/output/report_data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/output/curve_csv.hpp"
#include "apps/output/deflate.hpp"
#include "apps/output/film_data.hpp"
#include "apps/output/reference_series.hpp"
#include "apps/output/run_charts.hpp"
#include "apps/output/specimen_charts.hpp"
#include "apps/output/strain_unit.hpp"

namespace output {
namespace {

using Json = nlohmann::ordered_json;

/// Seven digits are more than a chart shows; a number that is not finite leaves a gap.
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

Json chart_json(const Chart& chart, const std::vector<Series>& references = {}) {
  return {{"title", chart.title},
          {"x", axis_json(chart.x)},
          {"y", axis_json(chart.y)},
          {"series", series_json(chart.series)},
          {"markers", markers_json(chart.markers)},
          {"references", series_json(references)}};
}

/// The same JSON, written so that no letter of it means anything in HTML.
std::string inert(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) switch (c) {
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

}  // namespace

std::string report_data(const RunRecord& record) {
  const StrainUnit unit = strain_unit(record.result);
  Json charts;
  charts["stress"] = chart_json(stress_chart(record), reference_series(record));
  charts["energy"] = chart_json(energy_chart(record));
  charts["failure"] = chart_json(failure_chart(record));
  charts["failure-strain"] = chart_json(failure_strain_chart(record));
  charts["sieve"] = chart_json(sieve_chart(record.specimen), sieve_references(record.specimen));
  const Json data = {{"strain", {{"name", unit.name}, {"per_strain", unit.per_strain}}},
                     {"csv", deflated_base64(curve_csv(record.result.history))},
                     {"charts", charts},
                     {"film", has_film(record) ? film_data(record) : Json(nullptr)}};
  return inert(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace output
