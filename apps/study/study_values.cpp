#include "apps/study/study_values.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include "apps/scene/toml.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

/// What people can read back and type again.
double to_digits(double number) { return std::stod(fmt::format("{:.4e}", number)); }

}  // namespace

const Measure* measure_of(const StudyParameter& parameter) {
  const Field& first = parameter.fields.front();
  return first.form.measure ? &*first.form.measure : nullptr;
}

bool takes_numbers(const StudyParameter& parameter) {
  const Kind kind = parameter.fields.front().form.kind;
  return measure_of(parameter) != nullptr || kind == Kind::integer;
}

Value written(const StudyParameter& parameter, double number) {
  const Measure* measure = measure_of(parameter);
  if (measure == nullptr) return {static_cast<std::int64_t>(std::llround(number))};
  return QuantityCodec{measure->dimension}.write(number);
}

std::vector<std::string> keys_of(const std::string& name) { return items_between(name, '+'); }

Value value_at_place(const StudyParameter& parameter, double u) {
  if (parameter.is_range()) {
    const double exact = parameter.low + u * (parameter.high - parameter.low);
    return written(parameter, std::clamp(to_digits(exact), parameter.low, parameter.high));
  }
  const auto count = static_cast<double>(parameter.levels.size());
  return parameter.levels[std::min(parameter.levels.size() - 1, static_cast<std::size_t>(u * count))];
}

std::string text_of(const StudyParameter& parameter, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return toml_text(value);
  const bool is_path = parameter.fields.front().form.kind == Kind::path && !text->empty();
  if (!is_path) return *text;
  const std::filesystem::path folder = parameter.folder.empty() ? "." : parameter.folder;
  return std::filesystem::path(*text).lexically_proximate(folder).generic_string();
}

double number_of(const StudyParameter& parameter, const Value& value) {
  if (!takes_numbers(parameter)) return std::numeric_limits<double>::quiet_NaN();
  const Measure* measure = measure_of(parameter);
  try {
    return measure == nullptr ? static_cast<double>(WholeNumberCodec().read(value))
                              : QuantityCodec{measure->dimension}.read(value);
  } catch (const Mistake&) {  // a word, such as "auto"
    return std::numeric_limits<double>::quiet_NaN();
  }
}

bool is_number(const StudyParameter& parameter) {
  return parameter.is_range() ||
         std::all_of(parameter.levels.begin(), parameter.levels.end(),
                     [&](const Value& value) { return std::isfinite(number_of(parameter, value)); });
}

ReadableUnit readable_unit(const StudyParameter& parameter) {
  static const std::map<Dimension, ReadableUnit> other_than_si{
      {Dimension::ratio, {}},
      {Dimension::length, {"mm", 1e3}},
      {Dimension::area, {"mm\u00b2", 1e6}},
      {Dimension::pressure, {"MPa", 1e-6}},
      {Dimension::angle, {"deg", 180 / std::numbers::pi}},
      {Dimension::time, {"ms", 1e3}}};
  const Measure* measure = measure_of(parameter);
  if (measure == nullptr) return {};
  const auto other = other_than_si.find(measure->dimension);
  return other == other_than_si.end() ? ReadableUnit{si_unit(measure->dimension), 1} : other->second;
}

std::string unit_of(const StudyParameter& parameter) {
  const Measure* measure = measure_of(parameter);
  return measure == nullptr ? "1" : si_unit(measure->dimension);
}

namespace {

constexpr std::array<std::string_view, 5> spread_keys{"from", "to", "steps", "low", "high"};
constexpr const char* forms =
    "must be a list [1, 2, 3], equal steps {from = 1, to = 3, steps = 5} or a range {low = 1, high = 3}";

/// Refused by a field, the value is named.
void try_on(const StudyParameter& parameter, const Value& value) {
  for (const Field& field : parameter.fields) {
    Settings settings;
    try {
      field.set(settings, value);
    } catch (const Mistake& mistake) {
      throw Mistake(toml_text(value) + ": " + mistake.allowed, mistake.cure);
    }
  }
}

void set_list(const Value::List& values, StudyParameter& parameter) {
  std::set<std::string> met;
  for (Value value : values) {
    if (parameter.fields.front().form.kind == Kind::path) value = within_folder(parameter.folder, value);
    try_on(parameter, value);
    if (!met.insert(toml_text(value)).second)
      throw Mistake(toml_text(value) + " stands there twice", "remove one");
    parameter.levels.push_back(std::move(value));
  }
  if (parameter.levels.empty()) throw Mistake("no value in the list", forms);
}

using Ends = std::map<std::string, Value>;

void check_keys(const Ends& ends) {
  for (const auto& [name, value] : ends)
    if (!is_spread_key(name)) {
      const std::string meant = did_you_mean(name, {spread_keys.begin(), spread_keys.end()});
      throw Mistake("unknown key " + printable(name), meant.empty() ? forms : meant);
    }
}

/// In SI units; whole numbers as they are.
double number_at(const Ends& ends, const char* key, const StudyParameter& parameter) {
  const Value& value = ends.at(key);
  const Measure* measure = measure_of(parameter);
  try {
    if (measure == nullptr) return static_cast<double>(WholeNumberCodec().read(value));
    return QuantityCodec{measure->dimension, measure->bounds}.read(value);
  } catch (const Mistake& mistake) {
    throw Mistake(std::string(key) + ": " + toml_text(value) + ": " + mistake.allowed, mistake.cure);
  }
}

void set_steps(const Ends& ends, StudyParameter& parameter) {
  const double from = number_at(ends, "from", parameter), to = number_at(ends, "to", parameter);
  const auto count = IntegerCodec<>{between(2, 10'000)}.read(ends.at("steps"));
  if (!(from != to)) throw Mistake("from and to are the same", "write a list of one value");
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const double number = i == count - 1 ? to : from + share * (to - from);
    if (measure_of(parameter) == nullptr && number != std::round(number))
      throw Mistake(fmt::format("{} steps from {} to {} are no whole numbers", count, from, to),
                    "choose other steps, or list the values");
    parameter.levels.push_back(written(parameter, number));
    try_on(parameter, parameter.levels.back());
  }
}

void set_range(const Ends& ends, StudyParameter& parameter) {
  if (measure_of(parameter) == nullptr)
    throw Mistake("a range is for quantities", "list the values: they are sampled evenly");
  parameter.low = number_at(ends, "low", parameter);
  parameter.high = number_at(ends, "high", parameter);
  if (!(parameter.low < parameter.high)) throw Mistake("low must be less than high");
  for (const double end : {parameter.low, parameter.high}) try_on(parameter, written(parameter, end));
}

}  // namespace

bool is_spread_key(std::string_view key) {
  return std::find(spread_keys.begin(), spread_keys.end(), key) != spread_keys.end();
}

Value within_folder(const std::string& folder, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr || text->empty()) return value;
  return {(std::filesystem::path(folder) / *text).lexically_normal().string()};
}

GivenValues given_values(const toml::node& node) {
  if (const toml::array* array = node.as_array()) {
    Value::List values;
    for (const toml::node& item : *array) {
      std::optional<Value> value = value_of(item);
      if (!value) throw Mistake("a table or a date in the list", forms);
      values.push_back(std::move(*value));
    }
    return values;
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) throw Mistake(forms);
  Ends ends;
  for (const auto& [key, item] : *table) {
    const std::string name(key.str());
    const std::optional<Value> value = value_of(item);
    if (!value && is_spread_key(name)) throw Mistake(name + ": a table or a date", forms);
    ends[name] = value.value_or(Value());
  }
  return ends;
}

void set_values(const GivenValues& given, StudyParameter& parameter) {
  if (const auto* list = std::get_if<Value::List>(&given)) return set_list(*list, parameter);
  const Ends& ends = std::get<Ends>(given);
  check_keys(ends);
  const auto has_only = [&](std::initializer_list<const char*> keys) {
    return ends.size() == keys.size() &&
           std::all_of(keys.begin(), keys.end(), [&](const char* key) { return ends.count(key) > 0; });
  };
  const bool steps = has_only({"from", "to", "steps"});
  if (!steps && !has_only({"low", "high"})) throw Mistake(forms);
  if (!takes_numbers(parameter)) throw Mistake("steps and ranges are for numbers", "list the values");
  if (steps)
    set_steps(ends, parameter);
  else
    set_range(ends, parameter);
}

std::string values_text(const StudyParameter& parameter) {
  if (!parameter.is_range()) return toml_text({parameter.levels});
  return fmt::format("{{low = {}, high = {}}}", toml_text(written(parameter, parameter.low)),
                     toml_text(written(parameter, parameter.high)));
}

}  // namespace app
