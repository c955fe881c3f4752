#include "apps/settings/schema.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "apps/settings/scene_lists.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

/// Field of one property of one phase.
Field bind(const PhaseField& property, const std::string& phase) {
  return {"phases." + phase + "." + property.key, property.help, property.form,
          [set = property.set, phase](Settings& settings, const Value& value) {
            set(phase_named(settings, phase), value);
          },
          [get = property.get, phase](const Settings& settings) {
            Settings copy = settings;  // a phase not yet there has its defaults
            return get(phase_named(copy, phase));
          }};
}

std::vector<std::string> keys_of_group(const std::string& group) {
  std::vector<std::string> keys;
  if (group == "phases")
    for (const PhaseField& property : phase_fields()) keys.push_back(property.key);
  if (const SceneList* list = find_list(group)) return item_keys(*list);
  for (const Field& field : fields_of(group)) keys.push_back(leaf_of(field.key));
  return keys;
}

bool is_one_of(std::string_view key, std::initializer_list<std::string_view> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Why the settings of a whole group have no effect on a specimen from this source.
std::string why_group_unused(const std::string& group, Source source) {
  const bool loaded = source == Source::file;
  if (loaded && (group == "generate" || group == "convert" || group == "itz"))
    return "has no effect on a specimen that is there already";
  if (group == "generate" && source == Source::picture) return "has no effect on a picture";
  if (group == "generate" && source == Source::ellipses) return "has no effect on given ellipses";
  if (group == "convert" && source != Source::picture) return "has an effect on pictures only";
  return {};
}

/// Whether the grid reaches beyond an edge of the specimen.
bool has_margin(const mpm::Scene& scene) {
  const mpm::Motion& motion = scene.motion;
  const auto ends = [](mpm::Edge edge) { return edge == mpm::Edge::closed || edge == mpm::Edge::open; };
  return ends(motion.left) || ends(motion.right) ||
         (scene.loading.direction == mpm::Direction::none && (ends(motion.bottom) || ends(motion.top)));
}

/// Why a setting of the loading or of moving points has no effect on a scene.
std::string why_motion_unused(std::string_view key, const mpm::Scene& scene) {
  const std::string group = group_of(key);
  const bool flies = scene.loading.direction == mpm::Direction::none;
  if ((group == "motion" || key == "loading.separation") && scene.kinematics == mpm::Kinematics::small_strain)
    return "has an effect with solver.kinematics = \"moving\" or \"auto\" only";
  if (group == "handover" && scene.kinematics != mpm::Kinematics::automatic)
    return "has an effect with solver.kinematics = \"auto\" only";
  if (scene.fixture.has_loads() &&
      is_one_of(key, {"loading.direction", "loading.platen", "loading.separation"}))
    return "has no effect beside [[loads]]";
  if (flies && is_one_of(key, {"loading.velocity", "loading.ramp_time", "loading.platen",
                               "loading.separation", "loading.stop_strain"}))
    return "has no effect with loading.direction = \"none\"";
  if (!flies && is_one_of(key, {"loading.initial_velocity_x", "loading.initial_velocity_y",
                                "loading.duration", "motion.bottom", "motion.top"}))
    return "has an effect with loading.direction = \"none\" only";
  if (key == "motion.flip_ratio" && scene.motion.transfer == mpm::Transfer::apic)
    return "has no effect with motion.transfer = \"apic\"";
  if (key == "motion.margin" && !has_margin(scene)) return "has no effect where no edge is closed or open";
  return {};
}

}  // namespace

std::string group_of(std::string_view key) { return std::string(key.substr(0, key.find_first_of(".["))); }

std::string leaf_of(std::string_view key) { return std::string(key.substr(key.rfind('.') + 1)); }

bool is_group(std::string_view name) {
  return std::any_of(groups().begin(), groups().end(),
                     [&](const Group& group) { return group.name == name; });
}

bool is_of_specimen(std::string_view key) {
  return is_one_of(group_of(key), {"specimen", "ellipses", "generate", "convert", "itz", "cuts"});
}

bool is_phase_name(std::string_view name) {
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.find_first_not_of(allowed) == std::string_view::npos;
}

std::vector<Field> fields_of(std::string_view group) {
  std::vector<Field> own;
  std::copy_if(fields().begin(), fields().end(), std::back_inserter(own),
               [&](const Field& field) { return group_of(field.key) == group; });
  return own;
}

std::vector<std::string> every_key(const Settings& settings) {
  std::vector<std::string> keys;
  for (const Field& field : fields()) keys.push_back(field.key);
  for (const mpm::Phase& phase : settings.phases)
    for (const PhaseField& property : phase_fields())
      keys.push_back("phases." + phase.name + "." + property.key);
  return keys;
}

std::optional<Field> find_field(std::string_view key) {
  for (const std::vector<Field>* table : {&fields(), &former_fields()})
    for (const Field& field : *table)
      if (field.key == key) return field;
  if (auto item = find_item_field(key)) return item;
  const std::size_t first = key.find('.');
  const std::size_t last = key.rfind('.');
  if (group_of(key) != "phases" || first == last) return std::nullopt;
  const std::string phase(key.substr(first + 1, last - first - 1));
  if (!is_phase_name(phase)) return std::nullopt;
  for (const PhaseField& property : phase_fields())
    if (property.key == key.substr(last + 1)) return bind(property, phase);
  return std::nullopt;
}

Suggestion suggest_key(std::string_view key, const Settings& settings) {
  const std::string group = group_of(key);
  const std::string leaf = leaf_of(key);
  const std::string prefix(key.substr(0, key.size() - leaf.size()));
  if (const std::string near = closest(leaf, keys_of_group(group)); !near.empty()) return {prefix + near, {}};
  for (const std::string& known : every_key(settings))
    if (leaf_of(known) == leaf) return {known, {}};
  if (const std::string near = closest(key, every_key(settings)); !near.empty()) return {near, {}};
  const std::vector<std::string> keys = keys_of_group(group);
  if (!keys.empty()) return {{}, group + " has " + listed(keys, "and")};
  std::vector<std::string> tables;
  for (const Group& one : groups()) tables.push_back(one.name);
  for (const SceneList& one : scene_lists()) tables.push_back(one.name);
  return {closest(group, tables), "the tables of a scene are " + listed(tables, "and")};
}

bool decides_use(std::string_view key) {
  return is_one_of(key, {"specimen.file", "specimen.picture", "specimen.ellipses", "ellipses",
                         "generate.classes", "loading.direction", "solver.method", "solver.kinematics",
                         "motion.transfer", "motion.left", "motion.right", "motion.bottom", "motion.top"});
}

std::string why_unused_by_method(std::string_view key, const mpm::Scene& scene) {
  const bool still = scene.method == mpm::SolverMethod::quasi_static;
  if (still && is_one_of(key, {"loading.velocity", "loading.ramp_time", "solver.cfl", "solver.local_damping",
                               "solver.precision", "output.history_rows"}))
    return "has no effect with solver.method = \"quasi_static\"";
  if (!still && is_one_of(key, {"solver.event_tolerance", "loading.path"}))
    return "has an effect with solver.method = \"quasi_static\" only";
  return {};
}

std::string why_unused(std::string_view key, const Settings& settings) {
  const SpecimenChoice& choice = settings.specimen;
  const bool has_file = !choice.file.empty() || !choice.picture.empty() || !choice.ellipses.empty();
  if (key == "specimen.sha256" && !has_file) return "is that of a file, and none is given";
  if (!settings.grading.classes.empty() &&
      is_one_of(key, {"generate.grading", "generate.d_min", "generate.d_max", "generate.walraven"}))
    return "has no effect beside generate.classes";
  if (const std::string reason = why_unused_by_method(key, settings.scene); !reason.empty()) return reason;
  if (const std::string reason = why_motion_unused(key, settings.scene); !reason.empty()) return reason;
  const Source source = source_of(settings);
  if (source == Source::ellipses &&
      is_one_of(key, {"generate.width", "generate.height", "generate.pixel_size"}))
    return {};  // drawn ellipses need them, random or not
  return why_group_unused(group_of(key), source);
}

}  // namespace app
