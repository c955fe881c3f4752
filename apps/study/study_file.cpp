#include "apps/study/study_file.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "apps/run/seed_runs.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
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
    std::set<std::uint64_t> met;
    for (const Value& item : *list) {
      seeds.push_back(IntegerCodec<std::uint64_t>{at_least(0)}.read(item));
      if (!met.insert(seeds.back()).second)
        throw Mistake("seed " + std::to_string(seeds.back()) + " stands there twice", "remove one");
    }
    if (seeds.empty()) throw Mistake("must be a number of seeds or a list of them");
    return seeds;
  }
  [[nodiscard]] static Value write(const std::vector<std::uint64_t>& seeds) {
    if (seeds == seeds_from(1, static_cast<int>(seeds.size())))
      return {static_cast<std::int64_t>(seeds.size())};
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
      field("title", TextCodec{}, "of the report", &StudyPlan::title),
      field("scene", PathCodec{{"toml"}}, "scene that every member begins with, relative to the study",
            &StudyPlan::scene),
      field("sampling", sampling, "how points fill the space of [vary]; grid by default",
            &StudyPlan::sampling),
      field("samples", IntegerCodec<>{between(1, most_values)}, "points, of all but a grid",
            &StudyPlan::samples),
      field("sampling_seed", IntegerCodec<std::uint64_t>{at_least(0)}, "of a Latin hypercube",
            &StudyPlan::sampling_seed),
      field("seeds", Seeds{}, "seeds that every point is run with: how many, from 1 on, or which",
            &StudyPlan::seeds),
      field("seed_of", SeedTables{},
            "tables whose seed varies; by default both of damage and generate that the scene "
            "has, so that each member is another specimen of the same kind",
            &StudyPlan::seed_of),
  };
  return all;
}

namespace {

void refuse_if_any(std::vector<Complaint> complaints) {
  if (complaints.empty()) return;
  std::stable_sort(complaints.begin(), complaints.end(),
                   [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
  throw Rejected(Exit::data, std::move(complaints));
}

}  // namespace

void PlanMaker::set(const std::string& name, const Value& value, const Place& place) {
  const auto& fields = study_fields();
  const auto field =
      std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.key == name; });
  places_[name] = place;
  try {
    field->set(plan_, field->form.kind == Kind::path ? within_folder(folder_, value) : value);
  } catch (const Mistake& mistake) {
    complain({place, name, toml_text(value), mistake.allowed, mistake.cure});
  }
}

void PlanMaker::vary(const std::string& name, const std::function<GivenValues()>& values,
                     const Place& of_name, const Place& of_values) {
  if (is_full()) return;  // a suggestion takes its time
  StudyParameter parameter{name, {}, {}, 0, 0, of_values, folder_};
  const std::string key_of_study = std::string(study_vary) + "." + printable(name);
  for (const std::string& key : keys_of(name)) {
    if (const auto field = find_field(key))
      parameter.fields.push_back(*field);
    else
      return complain({of_name,
                       key_of_study,
                       printable(key) + " is no key of a scene",
                       text(suggest_key(key, Settings())),
                       {}});
    if (!varied_.insert(key).second)
      return complain({of_name, key_of_study, key + " varies already", "name it once", {}});
  }
  try {
    set_values(values(), parameter);
    plan_.parameters.push_back(std::move(parameter));
  } catch (const Mistake& mistake) {
    complain({of_values, key_of_study, "", mistake.allowed, mistake.cure});
  }
}

Place PlanMaker::place(const std::string& key) const {
  const auto found = places_.find(key);
  return found == places_.end() ? Place{path_, 0, 0} : found->second;
}

void PlanMaker::check() {
  if (plan_.scene.empty())
    complain({place("scene"), "scene", "missing", "must be a scene file", "write scene = \"scene.toml\""});
  if (plan_.parameters.empty() && plan_.seeds.empty())
    complain({place("seeds"), "seeds", "nothing varies", "a study needs seeds, or keys in [vary]",
              "write seeds = 20"});
  check_sampling();
  check_seeds();
}

void PlanMaker::check_sampling() {
  const bool grid = plan_.sampling == Sampling::grid;
  if (grid && is_given("samples"))
    complain({place("samples"), "samples", "", "has no effect on a grid",
              "remove it, or choose sampling = \"sobol\""});
  if (!grid && !is_given("samples"))
    complain({place("sampling"), "samples", "missing", "must be the number of points", "write samples = 64"});
  if (!grid && plan_.parameters.empty())
    complain({place("sampling"), "sampling", "", "has no effect without keys in [vary]", "remove it"});
  if (plan_.sampling != Sampling::latin_hypercube && is_given("sampling_seed"))
    complain({place("sampling_seed"), "sampling_seed", "", "has an effect on a Latin hypercube only",
              "remove it"});
  for (const StudyParameter& parameter : plan_.parameters)
    if (grid && parameter.is_range())
      complain({parameter.place, std::string(study_vary) + "." + parameter.name, "a range",
                "a grid needs levels", "write {from, to, steps}, or choose sampling = \"sobol\""});
}

void PlanMaker::check_seeds() {
  if (is_given("seed_of") && plan_.seeds.empty())
    complain(
        {place("seed_of"), "seed_of", "", "has no effect without seeds", "remove it, or write seeds = 20"});
  for (const StudyParameter& parameter : plan_.parameters)
    for (const Field& field : parameter.fields)
      if (leaf_of(field.key) == "seed" && !plan_.seeds.empty())
        complain({parameter.place, std::string(study_vary) + "." + parameter.name, "", "given beside seeds",
                  "give one of the two; seed_of says which tables take the seeds"});
}

StudyPlan PlanMaker::plan() {
  if (complaints_.empty()) check();
  refuse_if_any(complaints_);
  // The parser keeps tables by name.
  std::stable_sort(plan_.parameters.begin(), plan_.parameters.end(),
                   [](const auto& a, const auto& b) { return stands_before(a.place, b.place); });
  plan_.seed_of_place = place("seed_of");
  return plan_;
}

namespace {

/// Walks a parsed file and tells the maker of the plan.
class Walk {
 public:
  explicit Walk(std::string path)
      : path_(std::move(path)), maker_(path_, std::filesystem::path(path_).parent_path().string()) {}

  StudyPlan read(const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (name == study_vary)
        varied(node);
      else
        setting(key, name, node);
    }
    return maker_.plan();
  }

 private:
  void setting(const toml::key& key, const std::string& name, const toml::node& node) {
    const auto& fields = study_fields();
    if (std::none_of(fields.begin(), fields.end(), [&](const auto& one) { return one.key == name; }))
      return unknown(place_of(key.source(), path_), name);
    const Place place = place_of(node.source(), path_);
    if (const std::optional<Value> value = value_of(node))
      maker_.set(name, *value, place);
    else
      maker_.complain({place, name, "a table or a date", "must be a single value", {}});
  }

  void unknown(const Place& place, const std::string& name) {
    if (maker_.is_full()) return;  // a suggestion takes its time
    std::vector<std::string> names{study_vary};
    for (const auto& field : study_fields()) names.push_back(field.key);
    const bool of_scene = find_field(name).has_value() || is_group(name);
    maker_.complain(
        unknown_key(place, printable(name),
                    {closest(name, names), of_scene ? "is of the scene; what varies of it stands in [vary]"
                                                    : "a study has " + listed(names, "and")}));
  }

  void varied(const toml::node& node) {
    if (const toml::table* table = node.as_table()) return parameters(*table, "");
    maker_.complain({place_of(node.source(), path_), study_vary, "must be a table", "write [vary]", {}});
  }

  void parameters(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, value] : table) {
      const std::string name = prefix + std::string(key.str());
      const toml::node& node = value;
      const toml::table* inner = node.as_table();
      // Keys without quotes make tables of their own: loading.velocity = [...] is the same as with them.
      if (inner != nullptr && is_table_of_scene(name) && !is_spread(*inner))
        parameters(*inner, name + ".");
      else
        maker_.vary(
            name, [&] { return given_values(node); }, place_of(key.source(), path_),
            place_of(node.source(), path_));
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

  std::string path_;
  PlanMaker maker_;
};

/// Both random fields, where the scene has both: each member is then another specimen of the same kind.
std::vector<std::string> default_seed_of(const Settings& settings) {
  std::vector<std::string> names;
  for (const char* name : {"generate", "damage"})
    if (why_unused(std::string(name) + ".seed", settings).empty()) names.emplace_back(name);
  return names;
}

}  // namespace

bool is_meant_as_study(const std::string& text, const std::string& path) {
  const toml::table table = parse_toml(text, path);
  return std::any_of(table.begin(), table.end(), [](const auto& entry) {
    return entry.first.str() == "scene" || entry.first.str() == study_vary;
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

std::string plan_text(const StudyPlan& plan, const std::filesystem::path& folder) {
  std::string text;
  for (const auto& field : study_fields()) {
    Value value = field.get(plan);
    if (value == field.get(StudyPlan())) continue;
    if (field.form.kind == Kind::path) value = relative_to(folder, value);
    text += field.key + " = " + toml_text(value) + "\n";
  }
  if (!plan.parameters.empty()) text += std::string("\n[") + study_vary + "]\n";
  for (const StudyParameter& parameter : plan.parameters)
    text += quoted(parameter.name) + " = " + values_text(parameter) + "\n";
  return text;
}

Study study_of(StudyPlan plan, Resolved base, TextFile file, TextFile scene) {
  if (plan.title.empty()) plan.title = std::filesystem::path(file.path).stem().string();
  if (plan.seed_of.empty()) plan.seed_of = default_seed_of(base.settings);
  return {std::move(plan), std::move(base), std::move(file), std::move(scene)};
}

Study study_of(TextFile file, TextFile scene) {
  StudyPlan plan = parse_study(file.text, file.path);
  Resolved base = resolve(parse_scene(scene.text, scene.path), {});
  return study_of(std::move(plan), std::move(base), std::move(file), std::move(scene));
}

Study read_study(const std::string& path) {
  const std::string text = read_text_file(path), scene = parse_study(text, path).scene;
  return study_of({text, path}, {read_text_file(scene), scene});
}

}  // namespace app
