// The JSON Schema of scene files.
#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/scene/ellipse_list.hpp"
#include "apps/settings/scene_lists.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* number_pattern = R"(([0-9]+\.?[0-9]*|\.[0-9]+))";
constexpr const char* positive_pattern = R"(([0-9]*[1-9][0-9]*(\.[0-9]*)?|[0-9]*\.[0-9]*[1-9][0-9]*))";

bool is_positive(const Bounds& bounds) { return bounds.low > 0 || (bounds.low == 0 && bounds.low_open); }

/// A unit as a regular expression.
std::string literal(const std::string& unit) {
  std::string pattern;
  for (const char c : unit) pattern += c == '^' || c == '.' ? std::string{'\\', c} : std::string{c};
  return pattern;
}

/// Texts that the quantity may be; of the bounds, a text shows the sign.
std::string pattern_of(const Measure& measure) {
  std::string units;
  for (const std::string& unit : unit_names(measure.dimension))
    units += (units.empty() ? "" : "|") + literal(unit);
  const bool may_go_without = measure.dimension == Dimension::ratio;
  return fmt::format(R"(^\s*{}{}([eE][-+]?[0-9]+)?\s*({}){}\s*$)", measure.bounds.low < 0 ? "[-+]?" : "\\+?",
                     is_positive(measure.bounds) ? positive_pattern : number_pattern, units,
                     may_go_without ? "?" : "");
}

/// Whole numbers without decimals, which not every validator takes for such.
Json limit(double value) {
  return std::floor(value) == value ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json with_bounds(Json type, const Bounds& bounds) {
  if (std::isfinite(bounds.low)) type[bounds.low_open ? "exclusiveMinimum" : "minimum"] = limit(bounds.low);
  if (std::isfinite(bounds.high))
    type[bounds.high_open ? "exclusiveMaximum" : "maximum"] = limit(bounds.high);
  return type;
}

/// What a quantity may be: a text with a unit; of a ratio a number too.
std::vector<Json> kinds_of(const Measure& measure) {
  std::vector<Json> kinds;
  if (measure.dimension == Dimension::ratio)
    kinds.push_back(with_bounds({{"type", "number"}}, measure.bounds));
  kinds.push_back({{"type", "string"}, {"pattern", pattern_of(measure)}});
  return kinds;
}

Json item_schema(const Items& items) {
  if (items.whole) return with_bounds({{"type", "integer"}}, *items.whole);
  if (!items.pattern.empty()) return {{"type", "string"}, {"pattern", items.pattern}};
  return {{"anyOf", kinds_of({})}};
}

Json list_schema(const Items& items) {
  Json list{{"type", "array"}, {"items", item_schema(items)}};
  if (items.number == 0) return list;
  list["minItems"] = list["maxItems"] = items.number;
  return {{"anyOf", {list, {{"type", "array"}, {"maxItems", 0}}}}};
}

/// Each a way to write the value.
std::vector<Json> kinds_of(const Form& form) {
  std::vector<Json> kinds;
  if (form.measure) kinds = kinds_of(*form.measure);
  if (form.whole) kinds.push_back(with_bounds({{"type", "integer"}}, *form.whole));
  if (form.items) kinds.push_back(list_schema(*form.items));
  if (form.kind == Kind::boolean) kinds.push_back({{"type", "boolean"}});
  if (form.kind == Kind::text || form.kind == Kind::path) kinds.push_back({{"type", "string"}});
  if (!form.words.empty()) kinds.push_back({{"type", "string"}, {"enum", form.words}});
  return kinds;
}

Json schema_of(const Form& form) {
  std::vector<Json> kinds = kinds_of(form);
  return kinds.size() == 1 ? kinds.front() : Json{{"anyOf", std::move(kinds)}};
}

struct ToJson {
  Json operator()(const Value::List& items) const {
    Json list = Json::array();
    for (const Value& item : items) list.push_back(std::visit(*this, item.data));
    return list;
  }
  template <class T>
  Json operator()(const T& value) const {
    return Json(value);
  }
};

std::string units_text(const Form& form) {
  if (!form.measure || form.measure->dimension == Dimension::ratio) return {};
  return "; units " + listed(unit_names(form.measure->dimension), "and");
}

/// @param what  the value is, in front of what it may be.
Json described(const std::string& what, const Form& form) {
  Json schema{{"description", what + text(form) + units_text(form)}};
  schema.update(schema_of(form));
  return schema;
}

/// The default of a text that is not given is none.
void add_default(Json& schema, const Value& value) {
  if (!is_empty_text(value)) schema["default"] = std::visit(ToJson{}, value.data);
}

/// A table that has these keys and no others.
Json closed_table(const std::string& title, Json properties) {
  return {{"title", title},
          {"type", "object"},
          {"properties", std::move(properties)},
          {"additionalProperties", false}};
}

/// @param defaults  nullptr = there are none.
template <class T>
Json table_schema(const std::string& title, const std::vector<FieldOf<T>>& fields, const T* defaults) {
  Json properties = Json::object();
  for (const FieldOf<T>& field : fields) {
    Json schema = described(field.help + "; ", field.form);
    if (defaults != nullptr) add_default(schema, field.get(*defaults));
    properties[leaf_of(field.key)] = std::move(schema);
  }
  return closed_table(title, std::move(properties));
}

Json phases_schema(const Group& group, const Settings& defaults) {
  Json known = Json::object();
  for (const mpm::Phase& phase : defaults.phases)
    known[phase.name] = table_schema("Phase " + phase.name, phase_fields(), &phase);
  Json schema = closed_table(group.title, std::move(known));
  schema["patternProperties"] = {
      {"^[A-Za-z0-9_-]+$", table_schema<mpm::Phase>("Phase", phase_fields(), nullptr)}};
  schema["maxProperties"] = most_phases;
  return schema;
}

Json ellipses_schema() {
  Json properties = Json::object();
  Json required = Json::array();
  for (const EllipseColumn& column : ellipse_columns) {
    properties[column.name] = described("", QuantityCodec{column.dimension}.form());
    if (column.required) required.push_back(column.name);
  }
  Json ellipse = closed_table("Ellipse", std::move(properties));
  ellipse["required"] = std::move(required);
  return {{"description",
           "ellipses one by one: centre from the bottom left corner, semi-axes a >= b, angle of a "
           "against x"},
          {"type", "array"},
          {"items", std::move(ellipse)}};
}

Json items_schema(const SceneList& list, const Settings& defaults) {
  Json item = table_schema(list.item, list.fields(0), &defaults);
  if (!list.required.empty()) item["required"] = list.required;
  for (const std::string& key : list.required) item["properties"][key].erase("default");
  return {
      {"description", list.help}, {"type", "array"}, {"maxItems", most_items}, {"items", std::move(item)}};
}

}  // namespace

nlohmann::ordered_json scene_schema() {
  const Settings defaults;
  Json properties{{"ellipses", ellipses_schema()}};
  for (const Group& group : groups())
    properties[group.name] = group.name == "phases"
                                 ? phases_schema(group, defaults)
                                 : table_schema(group.title, fields_of(group.name), &defaults);
  for (const SceneList& list : scene_lists()) properties[list.name] = items_schema(list, defaults);
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}};
  schema.update(closed_table(std::string("Scene of mesopix ") + version(), std::move(properties)));
  return schema;
}

}  // namespace app
