#include "apps/study/study_file.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "apps/run/seed_runs.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/toml.hpp"
#include "apps/settings/codec.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/files.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

constexpr int most_values = 100'000;

/// A number of seeds, from 1 on, or a list of them.
struct Seeds {
  [[nodiscard]] static Form form() { return {.kind = Kind::list, .name = "N|LIST"}; }
  [[nodiscard]] static std::vector<std::uint64_t> read(const Value& value) {
    const auto* list = std::get_if<Value::List>(&value.data);
    if (list == nullptr) return seeds_from(1, IntegerCodec<>{between(1, most_values)}.read(value));
    std::vector<std::uint64_t> seeds;
    for (const Value& item : *list) {
      seeds.push_back(IntegerCodec<std::uint64_t>{at_least(0)}.read(item));
      if (std::count(seeds.begin(), seeds.end(), seeds.back()) > 1)
        throw Mistake("seed " + std::to_string(seeds.back()) + " stands there twice", "remove one");
    }
    if (seeds.empty()) throw Mistake("must be a number of seeds or a list of them");
    return seeds;
  }
  [[nodiscard]] static Value write(const std::vector<std::uint64_t>& seeds) {
    Value::List items;
    for (const std::uint64_t seed : seeds) items.push_back({static_cast<std::int64_t>(seed)});
    return {items};
  }
};

/// Tables whose key `seed` may vary.
struct SeedTables : TextsCodec {
  [[nodiscard]] std::vector<std::string> read(const Value& value) const {
    std::vector<std::string> names = TextsCodec::read(value);
    for (const std::string& name : names) (void)WordCodec{{"damage", "generate"}}.read({name});
    if (names.empty()) throw Mistake("must name at least one of damage and generate");
    return names;
  }
};

template <class Codec, class Access>
FieldOf<StudyPlan> field(const char* key, Codec codec, const char* help, Access access) {
  return make_field<StudyPlan>(key, help, std::move(codec), access);
}

}  // namespace

const std::vector<FieldOf<StudyPlan>>& study_fields() {
  const ChoiceCodec<Sampling> sampling{
      {{"grid", Sampling::grid}, {"latin_hypercube", Sampling::latin_hypercube}, {"sobol", Sampling::sobol}}};
  static const std::vector<FieldOf<StudyPlan>> all{
      field(
          "title", TextCodec{}, "of the report", [](auto& plan) -> auto& { return plan.title; }),
      field(
          "scene", PathCodec{{"toml"}}, "scene that every member begins with, relative to the study",
          [](auto& plan) -> auto& { return plan.scene; }),
      field(
          "sampling", sampling, "how points fill the space of [vary]; grid by default",
          [](auto& plan) -> auto& { return plan.sampling; }),
      field(
          "samples", IntegerCodec<>{between(1, most_values)}, "points, of all but a grid",
          [](auto& plan) -> auto& { return plan.samples; }),
      field(
          "sampling_seed", IntegerCodec<std::uint64_t>{at_least(0)}, "of a Latin hypercube",
          [](auto& plan) -> auto& { return plan.sampling_seed; }),
      field(
          "seeds", Seeds{}, "seeds that every point is run with: how many, from 1 on, or which",
          [](auto& plan) -> auto& { return plan.seeds; }),
      field(
          "seed_of", SeedTables{},
          "tables whose seed varies; by default both of damage and generate that the scene "
          "has, so that each member is another specimen of the same kind",
          [](auto& plan) -> auto& { return plan.seed_of; }),
  };
  return all;
}

namespace {

constexpr const char* vary = study_vary;

/// Walks a parsed file and collects the plan and complaints.
class Walk {
 public:
  explicit Walk(std::string path)
      : path_(std::move(path)), folder_(std::filesystem::path(path_).parent_path()) {}

  StudyPlan read(const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (name == vary)
        varied(node);
      else
        setting(key, name, node);
    }
    if (complaints_.empty()) check();
    if (!complaints_.empty()) refuse();
    order(plan_.parameters);
    plan_.seed_of_place = place("seed_of");
    return plan_;
  }

 private:
  void complain(Place place, std::string field, std::string value, std::string allowed,
                std::string cure = {}) {
    complaints_.push_back(
        {std::move(place), std::move(field), std::move(value), std::move(allowed), std::move(cure)});
  }

  [[noreturn]] void refuse() {
    std::stable_sort(complaints_.begin(), complaints_.end(),
                     [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
    throw Rejected(Exit::data, complaints_);
  }

  static void order(std::vector<StudyParameter>& parameters) {  // the parser keeps tables by name
    std::stable_sort(parameters.begin(), parameters.end(),
                     [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
  }

  void setting(const toml::key& key, const std::string& name, const toml::node& node) {
    const auto& fields = study_fields();
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.key == name; });
    if (field == fields.end()) return unknown(place_of(key.source(), path_), name);
    const std::optional<Value> value = value_of(node);
    const Place place = place_of(node.source(), path_);
    places_[name] = place;
    if (!value) return complain(place, name, "a table or a date", "must be a single value");
    try {
      field->set(plan_, field->form.kind == Kind::path ? within_folder(*value) : *value);
    } catch (const Mistake& mistake) {
      complain(place, name, toml_text(*value), mistake.allowed, mistake.cure);
    }
  }

  Value within_folder(const Value& value) const {
    const auto* text = std::get_if<std::string>(&value.data);
    return text == nullptr || text->empty() ? value : Value{(folder_ / *text).lexically_normal().string()};
  }

  void unknown(const Place& place, const std::string& name) {
    std::vector<std::string> names{vary};
    for (const auto& field : study_fields()) names.push_back(field.key);
    const bool of_scene = find_field(name).has_value() || is_group(name);
    complaints_.push_back(
        unknown_key(place, printable(name),
                    {closest(name, names), of_scene ? "is of the scene; what varies of it stands in [vary]"
                                                    : "a study has " + listed(names, "and")}));
  }

  void varied(const toml::node& node) {
    if (const toml::table* table = node.as_table()) return parameters(*table, "");
    complain(place_of(node.source(), path_), vary, "must be a table", "write [vary]");
  }

  void parameters(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      const toml::table* inner = node.as_table();
      // Keys without quotes make tables of their own: loading.velocity = [...] is the same as with them.
      if (inner != nullptr && is_table_of_scene(name) && !is_spread(*inner))
        parameters(*inner, name + ".");
      else
        parameter(place_of(key.source(), path_), name, node);
    }
  }

  static bool is_table_of_scene(const std::string& name) {
    return name.find('+') == std::string::npos && !find_field(name);
  }

  static bool is_spread(const toml::table& table) {
    return table.empty() || std::any_of(table.begin(), table.end(), [](const auto& entry) {
             return !entry.second.is_table() && is_spread_key(entry.first.str());
           });
  }

  void parameter(const Place& place, const std::string& name, const toml::node& node) {
    StudyParameter parameter{name, {}, {}, 0, 0, place_of(node.source(), path_), folder_.string()};
    for (const std::string& key : keys_of(name)) {
      if (const auto field = find_field(key))
        parameter.fields.push_back(*field);
      else
        return complain(place, std::string(vary) + "." + printable(name),
                        printable(key) + " is no key of a scene", text(suggest_key(key, Settings())));
      if (!seen_.insert(key).second)
        return complain(place, std::string(vary) + "." + name, key + " varies already", "name it once");
    }
    try {
      read_values(node, parameter);
      plan_.parameters.push_back(std::move(parameter));
    } catch (const Mistake& mistake) {
      complain(parameter.place, std::string(vary) + "." + name, "", mistake.allowed, mistake.cure);
    }
  }

  Place place(const std::string& key) const {
    const auto found = places_.find(key);
    return found == places_.end() ? Place{path_, 0, 0} : found->second;
  }

  bool is_given(const std::string& key) const { return places_.count(key) > 0; }

  void check() {
    if (plan_.scene.empty())
      complain(place("scene"), "scene", "missing", "must be a scene file", "write scene = \"scene.toml\"");
    if (plan_.parameters.empty() && plan_.seeds.empty())
      complain(place("seeds"), "seeds", "nothing varies", "a study needs seeds, or keys in [vary]",
               "write seeds = 20");
    check_sampling();
    check_seeds();
  }

  void check_sampling() {
    const bool grid = plan_.sampling == Sampling::grid;
    if (grid && is_given("samples"))
      complain(place("samples"), "samples", "", "has no effect on a grid",
               "remove it, or choose sampling = \"sobol\"");
    if (!grid && !is_given("samples"))
      complain(place("sampling"), "samples", "missing", "must be the number of points", "write samples = 64");
    if (!grid && plan_.parameters.empty())
      complain(place("sampling"), "sampling", "", "has no effect without keys in [vary]", "remove it");
    if (plan_.sampling != Sampling::latin_hypercube && is_given("sampling_seed"))
      complain(place("sampling_seed"), "sampling_seed", "", "has an effect on a Latin hypercube only",
               "remove it");
    for (const StudyParameter& parameter : plan_.parameters)
      if (grid && parameter.is_range())
        complain(parameter.place, std::string(vary) + "." + parameter.name, "a range", "a grid needs levels",
                 "write {from, to, steps}, or choose sampling = \"sobol\"");
  }

  void check_seeds() {
    if (is_given("seed_of") && plan_.seeds.empty())
      complain(place("seed_of"), "seed_of", "", "has no effect without seeds",
               "remove it, or write seeds = 20");
    for (const StudyParameter& parameter : plan_.parameters)
      for (const Field& field : parameter.fields)
        if (leaf_of(field.key) == "seed" && !plan_.seeds.empty())
          complain(parameter.place, std::string(vary) + "." + parameter.name, "", "given beside seeds",
                   "give one of the two; seed_of says which tables take the seeds");
  }

  std::string path_;
  std::filesystem::path folder_;
  StudyPlan plan_;
  std::map<std::string, Place> places_;
  std::set<std::string> seen_;
  std::vector<Complaint> complaints_;
};

/// Both random fields, where the scene has both: each member is then another specimen of the same kind.
std::vector<std::string> default_seed_of(const Settings& settings) {
  std::vector<std::string> names;
  for (const char* name : {"generate", "damage"})
    if (why_unused(std::string(name) + ".seed", settings).empty()) names.emplace_back(name);
  return names;
}

/// With its scene, and what follows from it.   @throws Rejected for a scene that is not valid.
Study completed(StudyPlan plan, TextFile file, TextFile scene) {
  SceneFile base = parse_scene(scene.text, scene.path);
  const Resolved resolved = resolve(base, {});
  if (plan.title.empty()) plan.title = std::filesystem::path(file.path).stem().string();
  if (plan.seed_of.empty()) plan.seed_of = default_seed_of(resolved.settings);
  return {std::move(plan), std::move(base), std::move(file), std::move(scene)};
}

}  // namespace

bool is_meant_as_study(const std::string& text, const std::string& path) {
  const toml::table table = parse_toml(text, path);
  return std::any_of(table.begin(), table.end(), [](const auto& entry) {
    return entry.first.str() == "scene" || entry.first.str() == vary;
  });
}

std::string scene_of_study(const std::string& text, const std::string& path) {
  const auto scene = parse_toml(text, path)["scene"].value<std::string>();
  if (!scene || scene->empty()) return {};
  return (std::filesystem::path(path).parent_path() / *scene).lexically_normal().string();
}

StudyPlan parse_study(const std::string& text, const std::string& path) {
  return Walk(path).read(parse_toml(text, path));
}

Study read_study(const std::string& path) {
  TextFile file{read_text_file(path), path};
  StudyPlan plan = parse_study(file.text, path);
  TextFile scene{read_text_file(plan.scene), plan.scene};
  return completed(std::move(plan), std::move(file), std::move(scene));
}

Study study_of(TextFile file, TextFile scene) {
  StudyPlan plan = parse_study(file.text, file.path);
  return completed(std::move(plan), std::move(file), std::move(scene));
}

}  // namespace app
