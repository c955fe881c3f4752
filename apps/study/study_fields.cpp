#include "apps/study/study_fields.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "apps/settings/codec.hpp"
#include "apps/settings/form.hpp"
#include "apps/run/seed_runs.hpp"

namespace app {
namespace {

constexpr int most_seeds = 100'000;

/// A number of seeds, from 1 on, or a list of them.
struct Seeds {
  [[nodiscard]] static Kind kind() { return Kind::list; }
  [[nodiscard]] static std::string type() { return "N|LIST"; }
  [[nodiscard]] static std::vector<std::uint64_t> read(const Value& value) {
    const auto* list = std::get_if<Value::List>(&value.data);
    if (list == nullptr) return seeds_from(1, Integer<>{{between(1, most_seeds), {}}}.read(value));
    std::vector<std::uint64_t> seeds;
    for (const Value& item : *list) {
      seeds.push_back(Integer<std::uint64_t>{{at_least(0), {}}}.read(item));
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

Form form_of(const Seeds&) {
  Form form;
  form.kind = Kind::list;
  return form;
}

/// Tables whose key `seed` may vary.
struct SeedTables : Texts {
  [[nodiscard]] std::vector<std::string> read(const Value& value) const {
    std::vector<std::string> names = Texts::read(value);
    for (const std::string& name : names) (void)Name{{"damage", "generate"}}.read({name});
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
  const Choice<Sampling> sampling{
      {{"grid", Sampling::grid}, {"latin_hypercube", Sampling::latin_hypercube}, {"sobol", Sampling::sobol}}};
  static const std::vector<FieldOf<StudyPlan>> all{
      field(
          "title", Text{}, "of the report", [](auto& plan) -> auto& { return plan.title; }),
      field(
          "scene", Path{}, "scene that every member begins with, relative to the study",
          [](auto& plan) -> auto& { return plan.scene; }),
      field(
          "sampling", sampling, "how points fill the space of [vary]; grid by default",
          [](auto& plan) -> auto& { return plan.sampling; }),
      field(
          "samples", Integer<>{{between(1, most_seeds), {}}}, "points, of all but a grid",
          [](auto& plan) -> auto& { return plan.samples; }),
      field(
          "sampling_seed", Integer<std::uint64_t>{{at_least(0), {}}}, "of a Latin hypercube",
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

bool is_study_key(std::string_view key) {
  const auto& fields = study_fields();
  return key == study_vary || (key != "title" && std::any_of(fields.begin(), fields.end(),
                                                             [&](const auto& f) { return f.key == key; }));
}

}  // namespace app
