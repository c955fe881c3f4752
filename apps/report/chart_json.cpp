#include "apps/report/chart_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace output {
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

}  // namespace output
