#include "apps/scene/scene_doubt.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "apps/settings/schema.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

bool is_table(const std::string& name) { return name == "ellipses" || is_group(name); }

/// Whether a word stands in a text, not as the end of a longer one.
bool names(std::string_view text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
    if (at == 0 || (std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0 && text[at - 1] != '_'))
      return true;
  return false;
}

bool is_of_motion(std::string_view key) {
  const std::string group = group_of(key);
  return group == "loading" || group == "motion" || group == "handover" || key == "solver.kinematics";
}

}  // namespace

SceneDoubt::SceneDoubt(const std::vector<Complaint>& complaints, const std::string& left_out)
    : left_out_(left_out) {
  for (const Complaint& complaint : complaints) add_complaint(complaint);
  std::istringstream lines(left_out);
  for (std::string line; std::getline(lines, line);) add_line(trimmed(line));
}

bool SceneDoubt::is_about(std::string_view key) const {
  if (is_of_specimen(key)) return is_about_specimen();
  if (group_of(key) == "phases") return names(left_out_, leaf_of(key));
  return is_of_motion(key) && std::any_of(deciding_.begin(), deciding_.end(),
                                          [](const std::string& one) { return is_of_motion(one); });
}

bool SceneDoubt::is_about_specimen() const {
  return std::any_of(deciding_.begin(), deciding_.end(),
                     [](const std::string& one) { return is_of_specimen(one) && one != "generate.classes"; });
}

void SceneDoubt::add(std::string_view key) {
  if (decides_use(key)) deciding_.emplace(key);
}

void SceneDoubt::add_group(const std::string& group) {
  for (const Field& field : group.empty() ? fields() : fields_of(group)) add(field.key);
  if (group.empty()) add("ellipses");
}

void SceneDoubt::add_complaint(const Complaint& complaint) {
  add(complaint.field);
  add(complaint.meant);
  if (is_table(complaint.meant)) add_group(complaint.meant);
  if (group_of(complaint.field) != complaint.field) return;  // in a table
  if (is_table(complaint.field))
    add_group(complaint.field);  // which is no table
  else if (complaint.meant.empty())
    add_group("");
}

void SceneDoubt::add_line(std::string_view line) {
  if (!line.empty() && line.front() == '[') {
    const std::string_view name = line.substr(std::min(line.size(), line.find_first_not_of("[ \t")));
    const std::string group(name.substr(0, name.find_first_of(".] \t#")));
    return add_group(is_table(group) ? group : "");
  }
  for (const Field& field : fields())
    if (names(line, leaf_of(field.key))) add(field.key);
  if (names(line, "ellipses")) add("ellipses");
}

}  // namespace app
