#include "apps/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "apps/scene/ellipse_list.hpp"
#include "apps/scene/toml.hpp"
#include "apps/settings/scene_lists.hpp"
#include "apps/system/files.hpp"

namespace app {
namespace {

/// Walks a parsed file and collects assignments, ellipses and complaints.
class Walk {
 public:
  Walk(std::string path, SceneFile& scene)
      : path_(std::move(path)), folder_(std::filesystem::path(path_).parent_path()), scene_(scene) {}

  void root(const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (name == "ellipses")
        ellipses(node);
      else if (const SceneList* list = find_list(name))
        items(*list, node);
      else if (const auto* group = node.as_table(); group != nullptr && is_group(name))
        name == "phases" ? phases(*group) : settings(*group, name + ".");
      else
        unknown(key, name);
    }
  }

 private:
  Place place(const toml::source_region& source) const { return place_of(source, path_); }

  void complain(const toml::source_region& source, std::string field, std::string value, std::string allowed,
                std::string cure = {}) {
    if (is_full()) return;
    scene_.complaints.push_back(
        {place(source), std::move(field), std::move(value), std::move(allowed), std::move(cure)});
  }

  [[nodiscard]] bool is_full() const { return scene_.complaints.size() >= most_complaints; }

  void unknown(const toml::key& key, const std::string& name) {
    if (is_full()) return;  // a suggestion takes its time
    if (is_group(name)) return complain(key.source(), name, "must be a table", "write [" + name + "]");
    const bool of_study = std::find(study_keys.begin(), study_keys.end(), name) != study_keys.end();
    scene_.complaints.push_back(unknown_key(place(key.source()), name,
                                            of_study
                                                ? Suggestion{{}, "is of a study, which mesopix study runs"}
                                                : suggest_key(name, Settings())));
  }

  void phases(const toml::table& table) {
    if (table.size() > most_phases)
      return complain(table.source(), "phases", fmt::format("{} tables", table.size()),
                      fmt::format("must be at most {}", most_phases));
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (!is_phase_name(name))
        complain(key.source(), "phases." + printable(name), "not a name for a phase",
                 "must be letters, digits, _ and -");
      else if (const auto* phase = node.as_table())
        settings(*phase, "phases." + name + ".");
      else
        complain(key.source(), "phases." + name, "must be a table", "write [phases." + name + "]");
    }
  }

  void settings(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string full = prefix + std::string(key.str());
      const auto field = find_field(full);
      if (!field)
        unknown(key, full);
      else
        assign(full, field->form.kind, node);
    }
  }

  void items(const SceneList& list, const toml::node& node) {
    const auto* array = node.as_array();
    if (array == nullptr ||
        !std::all_of(array->begin(), array->end(), [](const toml::node& item) { return item.is_table(); }))
      return complain(node.source(), list.name, "not a list of tables",
                      fmt::format("write [[{}]] and below it {}", list.name, listed(item_keys(list), "and")));
    if (array->size() > most_items)
      return complain(node.source(), list.name, fmt::format("{} tables", array->size()),
                      fmt::format("must be at most {}", most_items));
    int number = 0;
    for (const toml::node& item : *array) {
      const std::string name = fmt::format("{}[{}]", list.name, ++number);
      const toml::table& table = *item.as_table();
      settings(table, name + ".");
      for (const std::string& key : list.required)
        if (!table.contains(key))
          complain(table.source(), name, key + " is missing",
                   list.item + " needs " + listed(list.required, "and"));
    }
  }

  void assign(const std::string& key, Kind kind, const toml::node& node) {
    std::optional<Value> value = value_of(node);
    if (!value) return complain(node.source(), key, "a table or a date", "must be a single value");
    const std::string written = toml_text(*value);
    if (auto* text = std::get_if<std::string>(&value->data);
        kind == Kind::path && text != nullptr && !text->empty())
      *text = (folder_ / *text).lexically_normal().string();
    scene_.assignments.push_back({key, std::move(*value), place(node.source()), key, written});
  }

  void ellipses(const toml::node& node) {
    const auto* array = node.as_array();
    if (array == nullptr ||
        !std::all_of(array->begin(), array->end(), [](const toml::node& item) { return item.is_table(); }))
      return complain(node.source(), "ellipses", "not a list of tables",
                      "write [[ellipses]] and below it x, y, a, b and angle");
    scene_.ellipses_place = place(node.source());
    int number = 0;
    for (const toml::node& item : *array)
      if (const auto* table = item.as_table()) ellipse(*table, fmt::format("ellipses[{}]", ++number));
  }

  void ellipse(const toml::table& table, const std::string& name) {
    specimen::Ellipse ellipse;
    const std::size_t before = scene_.complaints.size();
    for (const EllipseColumn& column : ellipse_columns) {
      const toml::node* node = table.get(column.name);
      if (node != nullptr)
        read_member(*node, name, column, ellipse);
      else if (column.required)
        complain(table.source(), name, std::string(column.name) + " is missing",
                 "an ellipse needs x, y, a and b");
    }
    for (const auto& [key, node] : table) ellipse_key(key, name);
    if (scene_.complaints.size() > before) return;
    try {
      check_axes(ellipse);
      scene_.ellipse_list.push_back(ellipse);
    } catch (const Mistake& mistake) {
      complain(table.source(), name, "", mistake.allowed, mistake.cure);
    }
  }

  void ellipse_key(const toml::key& key, const std::string& name) {
    std::vector<std::string> names;
    for (const EllipseColumn& column : ellipse_columns) names.emplace_back(column.name);
    if (std::find(names.begin(), names.end(), key.str()) == names.end() && !is_full())
      scene_.complaints.push_back(unknown_key(place(key.source()), name + "." + std::string(key.str()),
                                              {{}, "an ellipse has " + listed(names, "and")}));
  }

  void read_member(const toml::node& node, const std::string& name, const EllipseColumn& column,
                   specimen::Ellipse& ellipse) {
    const std::string key = name + "." + column.name;
    const std::optional<Value> value = value_of(node);
    if (!value) return complain(node.source(), key, "a table or a date", "must be a single value");
    try {
      ellipse.*column.member = QuantityCodec{column.dimension}.read(*value);
    } catch (const Mistake& mistake) {
      complain(node.source(), key, toml_text(*value), mistake.allowed, mistake.cure);
    }
  }

  std::string path_;
  std::filesystem::path folder_;
  SceneFile& scene_;
};

}  // namespace

SceneFile parse_scene(const std::string& text, const std::string& path) {
  SceneFile scene;
  Walk(path, scene).root(parse_toml(text, path));
  // The parser keeps its tables in alphabetical order; people read files from top to bottom.
  std::stable_sort(scene.assignments.begin(), scene.assignments.end(),
                   [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
  return scene;
}

SceneFile read_scene_file(const std::string& path) { return parse_scene(read_text_file(path), path); }

namespace {

/// Lay over the settings what was given, and remember where.
/// The strain at which a run ends that was not told: beyond the peak of concrete. A run that ends when the
/// stress drops has more room, which costs it nothing.
double usual_stop_strain(const mpm::Scene& scene) {
  const mpm::Loading& loading = scene.loading;
  if (scene.fixture.has_loads()) return 1e-2;
  if (loading.direction == mpm::Direction::compression) return loading.stop_drop ? 1e-2 : 4e-3;
  return loading.direction == mpm::Direction::tension && loading.stop_drop ? 1e-3
                                                                           : mpm::Loading{}.stop_strain;
}

void lay_over(const std::vector<Assignment>& given, Resolved& resolved, std::vector<Complaint>& complaints) {
  apply(given, resolved.settings, complaints);
  for (const Assignment& one : given) resolved.origins.insert_or_assign(one.key, one);
  mpm::Loading& loading = resolved.settings.scene.loading;
  if (!resolved.origins.contains("loading.stop_strain"))
    loading.stop_strain = usual_stop_strain(resolved.settings.scene);
  std::vector<mpm::Load>& loads = resolved.settings.scene.fixture.loads;
  if (loads.size() == 1) loads.front().leads = true;
  const SpecimenChoice& choice = resolved.settings.specimen;
  if (choice.ellipse_list.empty() && !choice.ellipses.empty())
    resolved.origins["ellipses"] = {"ellipses", {}, {choice.ellipses, 0, 0}, "ellipses", ""};
}

Resolved accepted(Resolved resolved, std::vector<Complaint> complaints) {
  if (complaints.empty()) complaints = check_use(resolved.origins, resolved.settings);
  if (complaints.empty()) return resolved;
  const bool of_file = !complaints.front().place.file.empty();
  throw Rejected(of_file ? Exit::data : Exit::usage, complaints);
}

}  // namespace

Resolved resolve_what_can_be(const SceneFile& scene, const std::vector<Assignment>& command_line,
                             std::vector<Complaint>& complaints) {
  Resolved resolved;
  std::vector<Complaint> of_file = scene.complaints;
  resolved.settings.specimen.ellipse_list = scene.ellipse_list;
  if (!scene.ellipse_list.empty())
    resolved.origins["ellipses"] = {"ellipses", {}, scene.ellipses_place, "ellipses", ""};
  lay_over(scene.assignments, resolved, of_file);
  std::stable_sort(of_file.begin(), of_file.end(),
                   [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
  complaints.insert(complaints.end(), of_file.begin(), of_file.end());
  lay_over(command_line, resolved, complaints);
  return resolved;
}

Resolved resolve(const SceneFile& scene, const std::vector<Assignment>& command_line) {
  std::vector<Complaint> complaints;
  Resolved resolved = resolve_what_can_be(scene, command_line, complaints);
  return accepted(std::move(resolved), std::move(complaints));
}

Resolved resolve_over(Resolved base, const std::vector<Assignment>& given) {
  std::vector<Complaint> complaints;
  lay_over(given, base, complaints);
  return accepted(std::move(base), std::move(complaints));
}

}  // namespace app
