#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <sstream>

#include "apps/scene/ellipse_list.hpp"
#include "apps/scene/toml.hpp"
#include "apps/settings/scene_lists.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// Of the table that holds a key: "[loading]"; "[[loads]]" of "loads[2]".
std::string heading_of(const std::string& table) {
  const std::size_t item = table.find('[');
  return item == std::string::npos ? "[" + table + "]" : "[[" + table.substr(0, item) + "]]";
}

template <class T>
std::string line(const FieldOf<T>& field, const Value& value) {
  const std::string setting = fmt::format("{} = {}", leaf_of(field.key), toml_text(value));
  const std::string choices = field.form.kind == Kind::choice ? " (" + type(field.form) + ")" : "";
  return fmt::format("{:<32} # {}{}\n", setting, field.help, choices);
}

/// Every setting of an item that has a value.
template <class See>
void each_item(const Settings& settings, Extent extent, const See& see) {
  for (const SceneList& list : scene_lists()) {
    if (extent == Extent::specimen && !is_of_specimen(list.name)) continue;
    for (std::size_t i = 0; i < list.size(settings); ++i)
      for (const Field& field : list.fields(i))
        if (const Value value = field.get(settings); !is_empty_text(value) && !is_empty_list(value))
          see(field.key, field, value);
  }
}

/// Every setting that has an effect and a value, in the order of the schema.
/// @param see  takes its whole key, its field and its value.
template <class See>
void each_in_use(const Settings& settings, Extent extent, const See& see) {
  for (const Group& group : groups()) {
    if (extent == Extent::specimen && !is_of_specimen(group.name)) continue;
    if (group.name == "phases")
      for (const mpm::Phase& phase : settings.phases)
        for (const PhaseField& property : phase_fields())
          see("phases." + phase.name + "." + property.key, property, property.get(phase));
    for (const Field& field : fields_of(group.name)) {
      if (!why_unused(field.key, settings).empty()) continue;
      if (const Value value = field.get(settings); !is_empty_text(value)) see(field.key, field, value);
    }
  }
  each_item(settings, extent, see);
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

/// A number in SI units where a quantity is written with a unit; words and lists as they are.
template <class T>
Value exact(const FieldOf<T>& field, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (!field.form.measure || text == nullptr) return value;
  try {
    return {parse_quantity(*text, field.form.measure->dimension)};
  } catch (const Mistake&) {  // a word, such as "auto"
    return value;
  }
}

Value exact(const specimen::Grading& classes) {
  Value::List numbers;
  for (const specimen::SizeClass& one : classes)
    for (const double number : {one.d_min, one.d_max, one.share}) numbers.push_back({number});
  return {numbers};
}

Value exact(const std::vector<specimen::Ellipse>& ellipses) {
  Value::List numbers;
  for (const specimen::Ellipse& ellipse : ellipses)
    for (const EllipseColumn& column : ellipse_columns) numbers.push_back({ellipse.*column.member});
  return {numbers};
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
  std::string table;
  each_in_use(settings, extent, [&](const std::string& key, const auto& field, const Value& value) {
    if (const std::string mine = key.substr(0, key.rfind('.')); mine != table) {
      text += "\n" + heading_of(mine) + "\n";
      table = mine;
    }
    text += line(field, field.form.kind == Kind::path ? relative_to(folder, value) : value);
  });
  return text;
}

std::string scene_values(const Settings& settings, Extent extent) {
  std::map<std::string, Value> values;
  each_in_use(settings, extent, [&](const std::string& key, const auto& field, const Value& value) {
    values[key] = field.form.kind == Kind::path
                      ? Value{fs::path(std::get<std::string>(value.data)).filename().string()}
                      : exact(field, value);
  });
  if (const auto classes = values.find("generate.classes"); classes != values.end())
    classes->second = exact(settings.grading.classes);
  values["ellipses"] = exact(settings.specimen.ellipse_list);
  std::string text;
  for (const auto& [key, value] : values) text += key + " = " + toml_text(value) + "\n";
  return text;
}

Resolved as_written(Settings settings) {
  Origins origins;
  each_in_use(settings, Extent::whole,
              [&](const std::string& key, const auto& /*field*/, const Value& value) {
                origins[key] = {key, value, {}, key, toml_text(value)};
              });
  if (!settings.specimen.ellipse_list.empty()) origins["ellipses"] = {"ellipses", {}, {}, "ellipses", ""};
  return {std::move(settings), std::move(origins)};
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
    throw Rejected(Exit::data, "the scene of a run", text(why), "",
                   "take the run folder as mesopix wrote it");
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
