#include "apps/run/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace app {
namespace {

constexpr double nano = 1e-9;

std::string bytes_text(double bytes) { return bytes > 0 ? fmt::format("{:.0f}", bytes) : std::string("-"); }

/// A difference that is smaller than what such a measurement can tell, below 0 at times, is shown as such.
std::string time_text(const mpm::Feature& feature, double run) {
  if (!feature.time) return "-";
  const double least = 0.05 * run;
  if (*feature.time < least) return fmt::format("< {:.2f}", least / nano);
  return fmt::format("{:.2f}", *feature.time / nano);
}

std::string rows(const mpm::Explanation& explanation, bool in, std::size_t width) {
  std::string text;
  for (const mpm::Feature& feature : explanation.features)
    if (feature.in == in)
      text += fmt::format("  {:<{}}  {:>5}  {:>7}  {}\n", feature.name, width, bytes_text(feature.bytes),
                          time_text(feature, explanation.time), feature.why);
  return text;
}

}  // namespace

std::string explanation_text(const mpm::Explanation& explanation) {
  std::size_t width = 0;
  for (const mpm::Feature& feature : explanation.features) width = std::max(width, feature.name.size());
  std::string text =
      fmt::format("{}: {:.0f} bytes a point, {:.2f} ns a point and step, measured on this scene\n\n",
                  explanation.kinematics, explanation.bytes, explanation.time / nano);
  text += fmt::format("  {:<{}}  {:>5}  {:>7}\n", "", width, "bytes", "ns");
  text += "In, and what it takes a point:\n" + rows(explanation, true, width);
  text += "Left out, and what that saves a point:\n" + rows(explanation, false, width);
  return text;
}

nlohmann::ordered_json explanation_json(const mpm::Explanation& explanation) {
  nlohmann::ordered_json features = nlohmann::ordered_json::array();
  for (const mpm::Feature& feature : explanation.features) {
    nlohmann::ordered_json one{
        {"name", feature.name}, {"in", feature.in}, {"why", feature.why}, {"bytes_per_point", feature.bytes}};
    if (feature.time) one["s_per_point_update"] = *feature.time;
    features.push_back(std::move(one));
  }
  return {{"kinematics", explanation.kinematics},
          {"bytes_per_point", explanation.bytes},
          {"s_per_point_update", explanation.time},
          {"features", std::move(features)}};
}

}  // namespace app
