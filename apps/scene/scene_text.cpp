#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>

#include "apps/scene/ellipse_list.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// A text setting that was not given is left out: it has no default that could be written.
bool is_empty_text(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  return text != nullptr && text->empty();
}

template <class T>
std::string line(const FieldOf<T>& field, const Value& value) {
  const std::string setting = fmt::format("{} = {}", leaf_of(field.key), toml_text(value));
  const std::string choices = field.kind == Kind::choice ? " (" + field.type + ")" : "";
  return fmt::format("{:<32} # {}{}\n", setting, field.help, choices);
}

std::string group_lines(const std::string& group, const Settings& settings, const fs::path& folder) {
  std::string lines;
  for (const Field& field : fields()) {
    if (group_of(field.key) != group || !why_unused(field.key, settings).empty()) continue;
    Value value = field.get(settings);
    if (is_empty_text(value)) continue;
    if (field.kind == Kind::path) value = relative_to(folder, value);
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

bool of_specimen(const std::string& group) {
  return group == "specimen" || group == "generate" || group == "convert" || group == "itz";
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
    if (extent == Extent::specimen && !of_specimen(group.name)) continue;
    if (group.name == "phases")
      for (const mpm::Phase& phase : settings.phases)
        text += table("phases." + phase.name, phase_lines(phase));
    else
      text += table(group.name, group_lines(group.name, settings, folder));
  }
  return text;
}

}  // namespace app
