/// The values that a parameter of a study takes, and how a study file says them.
#pragma once

#include <toml++/toml.h>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/study/study.hpp"

namespace app {

/// Keys of the scene in "generate.width + generate.height".
[[nodiscard]] std::vector<std::string> keys_of(const std::string& name);

/// What the values measure; nullptr for whole numbers and all that is no number.
[[nodiscard]] const Measure* measure_of(const StudyParameter& parameter);

/// Whether the fields take numbers, words such as "auto" beside them.
[[nodiscard]] bool takes_numbers(const StudyParameter& parameter);

/// A number in SI units as the scene file writes it; rounded where the fields take whole numbers.
/// @pre takes_numbers().
[[nodiscard]] Value written(const StudyParameter& parameter, double number);

/// Value of the parameter at a place u in [0, 1): levels share the places evenly, a range goes in proportion,
/// to five digits.
[[nodiscard]] Value value_at_place(const StudyParameter& parameter, double u);

/// A value as the study file writes it, texts without quotes.
[[nodiscard]] std::string text_of(const StudyParameter& parameter, const Value& value);

/// A value as a number in SI units, where it is one.   @return NaN for words.
[[nodiscard]] double number_of(const StudyParameter& parameter, const Value& value);

/// Whether each value of the parameter is a number.
[[nodiscard]] bool is_number(const StudyParameter& parameter);

/// A unit that people read, and how much of it an SI unit is.
struct ReadableUnit {
  std::string name;  ///< "MPa"; empty for numbers without a unit
  double per_si = 1;
};
[[nodiscard]] ReadableUnit readable_unit(const StudyParameter& parameter);

/// "Pa"; "1" for numbers without a unit.
[[nodiscard]] std::string unit_of(const StudyParameter& parameter);

/// Whether a key is one of those that say how values spread: from, to, steps, low, high.
[[nodiscard]] bool is_spread_key(std::string_view key);

/// A path that is relative to a folder, as the program takes it; what is no text stays as it is.
[[nodiscard]] Value within_folder(const std::string& folder, const Value& value);

/// A list [1, 2, 3], or equal steps {from, to, steps} or a range {low, high} by these keys.
using GivenValues = std::variant<Value::List, std::map<std::string, Value>>;

/// As a study file says it.   @throws Mistake for what is neither a list nor a table of values.
[[nodiscard]] GivenValues given_values(const toml::node& node);

/// Give the values to the parameter, whose fields are known, and try each of them on all fields.
/// @throws Mistake.
void set_values(const GivenValues& given, StudyParameter& parameter);

/// The same the other way: values that a study file gives the parameter, as TOML.
[[nodiscard]] std::string values_text(const StudyParameter& parameter);

}  // namespace app
