#include "apps/manual/setting_words.hpp"

#include <algorithm>

#include "apps/scene/ellipse_list.hpp"
#include "apps/settings/scene_lists.hpp"
#include "apps/text/words.hpp"

namespace manual {
namespace {

using app::Value;

/// "> 0", "in [2, 16], or "auto""; "any" number; empty where the type says it all.
std::string allowed_by(const app::Form& form) {
  if (!form.measure && !form.whole) return {};
  std::string allowed = form.whole ? form.whole->range(app::Dimension::ratio)
                                   : form.measure->bounds.range(form.measure->dimension);
  if (allowed.empty()) allowed = "any";
  for (const std::string& word : form.words) allowed += ", or " + app::quoted(word);
  return allowed;
}

std::string default_of(const Value& value) {
  const bool is_none = is_empty_text(value) || value == Value{Value::List()};
  return is_none ? std::string() : toml_text(value);
}

/// Of a property in each of the phases that there are by default: "40 GPa (aggregate), ..."; one alone where
/// it is the same in all.
std::string phase_defaults(const app::PhaseField& property) {
  const std::vector<mpm::Phase> phases = app::Settings().phases;
  const Value first = property.get(phases.front());
  if (std::all_of(phases.begin(), phases.end(),
                  [&](const auto& phase) { return property.get(phase) == first; }))
    return toml_text(first);
  std::string text;
  for (const mpm::Phase& phase : phases)
    text += (text.empty() ? "" : ", ") + toml_text(property.get(phase)) + " (" + phase.name + ")";
  return text;
}

template <class Field>
SettingWords words_of(const Field& field, std::string default_value) {
  const bool is_switch = field.form.kind == app::Kind::boolean;
  return {app::leaf_of(field.key), is_switch ? "true|false" : type(field.form), std::move(default_value),
          allowed_by(field.form), field.help};
}

}  // namespace

std::vector<TableWords> scene_tables() {
  std::vector<TableWords> tables;
  const app::Settings defaults;
  for (const app::Group& group : app::groups()) {
    tables.push_back({group.name, group.title, {}});
    TableWords& table = tables.back();
    for (const app::Field& field : app::fields_of(group.name))
      table.settings.push_back(words_of(field, default_of(field.get(defaults))));
    if (group.name != "phases") continue;
    table.name = "phases.NAME";
    for (const app::PhaseField& property : app::phase_fields())
      table.settings.push_back(words_of(property, phase_defaults(property)));
  }
  return tables;
}

std::vector<TableWords> list_tables() {
  std::vector<TableWords> tables;
  const app::Settings defaults;
  for (const app::SceneList& list : app::scene_lists()) {
    tables.push_back({"[" + list.name + "]", list.help, {}});
    for (const app::Field& field : list.fields(0)) {
      const bool is_required = std::find(list.required.begin(), list.required.end(),
                                         app::leaf_of(field.key)) != list.required.end();
      tables.back().settings.push_back(words_of(field, is_required ? "" : default_of(field.get(defaults))));
    }
  }
  return tables;
}

std::vector<std::string> about_scenes() {
  return {
      "A scene says what is broken and how: where the specimen comes from, its phases, the loading, the "
      "solver, and "
      "what is kept. It is a file in TOML, called something.toml. Every setting has a default, so that an "
      "empty file "
      "is a scene too. mesopix simulate --print-scene prints a scene with all settings that have an effect, "
      "and "
      "every run keeps its own as scene.toml.",
      "Quantities are texts with a unit, as \"0.05 m/s\"; ratios are numbers or texts like \"20 %\". Names "
      "of files "
      "are relative to the folder of the scene. A key that does not exist, a value that is not allowed and a "
      "setting "
      "that would have no effect are refused, with their line.",
      "Every key is also an option of the commands that it concerns, as --loading.velocity \"0.1 m/s\", and "
      "what the "
      "command line says counts more than what the file says.",
      "The specimen is that of one of specimen.file, specimen.picture, specimen.ellipses and [[ellipses]]; "
      "without "
      "them it is drawn at random by the settings of [generate].",
  };
}

std::string about_ellipses() {
  std::vector<std::string> required;
  std::vector<std::string> optional;
  for (const app::EllipseColumn& column : app::ellipse_columns)
    (column.required ? required : optional).emplace_back(column.name);
  return "Aggregates may stand in the scene itself, each a table [[ellipses]] with " +
         app::listed(required, "and") + ", and with " + app::listed(optional, "and") +
         " where it is not 0: the place of the centre from the bottom left corner, the semi-axes, of which a "
         "is the "
         "longer one, and the angle of a against x, counter-clockwise.";
}

std::vector<TypeWords> quantity_types() {
  using app::Dimension;
  std::vector<TypeWords> types;
  for (const Dimension dimension :
       {Dimension::ratio, Dimension::length, Dimension::area, Dimension::pressure, Dimension::angle,
        Dimension::velocity, Dimension::density, Dimension::time, Dimension::energy})
    types.push_back(
        {app::QuantityCodec{dimension}.form().name,
         (dimension == Dimension::ratio ? "no unit, " : "") + app::listed(app::unit_names(dimension)),
         app::example(dimension)});
  return types;
}

}  // namespace manual
