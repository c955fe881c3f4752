#include "apps/scene/scene_differences.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "apps/text/complaint.hpp"
#include "apps/text/text.hpp"
#include "apps/scene/toml_value.hpp"

namespace app {
namespace {

using Values = std::map<std::string, std::string>;

/// Numbers as short as they can be, everything else as TOML writes it.
std::string written(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return output::exact(number->get());
  std::string text;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& item : *array) text += (text.empty() ? "" : ", ") + written(item);
    return "[" + text + "]";
  }
  std::ostringstream other;
  node.visit([&](const auto& value) { other << toml::toml_formatter(value); });
  return other.str();
}

void collect(const toml::table& table, const std::string& prefix, Values& values) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table())
      collect(*inner, name + ".", values);
    else
      values[name] = written(node);
  }
}

Values values_of(const std::string& scene) {
  Values values;
  try {
    collect(parse_toml(scene, ""), "", values);
  } catch (const Rejected& rejected) {
    Complaint why = rejected.complaints.front();
    why.place = {};  // of a text that the user has not before him
    throw Rejected(Exit::data,
                   complaint("the scene of a run", text(why), "", "take the run folder as mesopix wrote it"));
  }
  return values;
}

}  // namespace

std::vector<SceneDifference> scene_differences(const std::vector<std::string>& scenes) {
  std::map<std::string, SceneDifference> all;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const auto& [key, value] : values_of(scenes[i])) {
      SceneDifference& one = all[key];
      one.key = key;
      one.values.resize(scenes.size());
      one.values[i] = value;
    }
  std::vector<SceneDifference> differences;
  for (const auto& entry : all) {
    const SceneDifference& one = entry.second;
    if (std::any_of(one.values.begin(), one.values.end(),
                    [&](const std::string& value) { return value != one.values.front(); }))
      differences.push_back(one);
  }
  return differences;
}

}  // namespace app
