#include "apps/study/study_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "apps/text/text_parts.hpp"

namespace app {
namespace {

/// What people can read back and type again.
double to_digits(double number) { return std::stod(fmt::format("{:.4e}", number)); }

}  // namespace

const Measure* measure_of(const StudyParameter& parameter) {
  const Field& first = parameter.fields.front();
  return first.measure ? &*first.measure : nullptr;
}

bool takes_numbers(const StudyParameter& parameter) {
  const Kind kind = parameter.fields.front().kind;
  return measure_of(parameter) != nullptr || kind == Kind::integer;
}

Value written(const StudyParameter& parameter, double number) {
  const Measure* measure = measure_of(parameter);
  if (measure == nullptr) return {static_cast<std::int64_t>(std::llround(number))};
  return Quantity{measure->dimension, {}, {}}.write(number);
}

std::vector<std::string> keys_of(const std::string& name) {
  std::vector<std::string> keys;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t to = std::min(name.find('+', from), name.size());
    keys.emplace_back(trimmed(std::string_view(name).substr(from, to - from)));
    from = to + 1;
  }
  return keys;
}

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
  const bool is_path = parameter.fields.front().kind == Kind::path && !text->empty();
  if (!is_path) return *text;
  const std::filesystem::path folder = parameter.folder.empty() ? "." : parameter.folder;
  return std::filesystem::path(*text).lexically_proximate(folder).generic_string();
}

double number_of(const StudyParameter& parameter, const Value& value) {
  if (!takes_numbers(parameter)) return std::numeric_limits<double>::quiet_NaN();
  const Measure* measure = measure_of(parameter);
  try {
    return measure == nullptr ? static_cast<double>(WholeNumber().read(value))
                              : Quantity{measure->dimension, {}, {}}.read(value);
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
  const Measure* measure = measure_of(parameter);
  if (measure == nullptr) return {};
  switch (measure->dimension) {
    case Dimension::ratio:
      return {};
    case Dimension::length:
      return {"mm", 1e3};
    case Dimension::area:
      return {"mm\u00b2", 1e6};
    case Dimension::pressure:
      return {"MPa", 1e-6};
    case Dimension::angle:
      return {"deg", 180 / std::numbers::pi};
    case Dimension::time:
      return {"ms", 1e3};
    case Dimension::velocity:
    case Dimension::density:
    case Dimension::energy:
      break;
  }
  return {si_unit(measure->dimension), 1};
}

std::string unit_of(const StudyParameter& parameter) {
  const Measure* measure = measure_of(parameter);
  return measure == nullptr ? "1" : si_unit(measure->dimension);
}

}  // namespace app
