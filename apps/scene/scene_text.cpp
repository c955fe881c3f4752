#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <sstream>

#include "apps/scene/ellipse_list.hpp"
#include "apps/scene/toml.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

template <class T>
std::string line(const FieldOf<T>& field, const Value& value) {
  const std::string setting = fmt::format("{} = {}", leaf_of(field.key), toml_text(value));
  const std::string choices = field.form.kind == Kind::choice ? " (" + type(field.form) + ")" : "";
  return fmt::format("{:<32} # {}{}\n", setting, field.help, choices);
}

std::string group_lines(const std::string& group, const Settings& settings, const fs::path& folder) {
  std::string lines;
  for (const Field& field : fields_of(group)) {
    if (!why_unused(field.key, settings).empty()) continue;
    Value value = field.get(settings);
    if (is_empty_text(value)) continue;
    if (field.form.kind == Kind::path) value = relative_to(folder, value);
    lines += line(field, value);
  }
  return lines;
}

std::string phase_lines(const mpm::Phase& phase) {
  std::string lines;
  for (const PhaseField& property : phase_fields()) lines += line(property, property.get(phase));
  return lines;
}

std::string ellipse_lines(const std::vector<specimen::Ellipse>& ellipses) {
  if (ellipses.empty()) return {};
  std::string text = "ellipses = [  # centre from the bottom left corner, semi-axes, angle of a against x\n";
  for (const specimen::Ellipse& ellipse : ellipses) {
    std::string members;
    for (const EllipseColumn& column : ellipse_columns)
      members += fmt::format("{}{} = {}", members.empty() ? "" : ", ", column.name,
                             quoted(format_quantity(ellipse.*column.member, column.dimension)));
    text += "  {" + members + "},\n";
  }
  return text + "]\n";
}

std::string table(const std::string& name, const std::string& lines) {
  return lines.empty() ? "" : fmt::format("\n[{}]\n{}", name, lines);
}

}  // namespace

Value relative_to(const std::filesystem::path& folder, const Value& value) {
  const std::filesystem::path path = std::get<std::string>(value.data);
  const std::filesystem::path base = fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal();
  return {fs::absolute(path).lexically_normal().lexically_proximate(base).generic_string()};
}

std::string scene_text(const Settings& settings, Extent extent, const fs::path& folder) {
  std::string text =
      fmt::format("# A scene of mesopix {}.\n", version()) + ellipse_lines(settings.specimen.ellipse_list);
  for (const Group& group : groups()) {
    if (extent == Extent::specimen && !is_of_specimen(group.name)) continue;
    if (group.name == "phases")
      for (const mpm::Phase& phase : settings.phases)
        text += table("phases." + phase.name, phase_lines(phase));
    else
      text += table(group.name, group_lines(group.name, settings, folder));
  }
  return text;
}

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
