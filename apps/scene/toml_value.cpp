#include "apps/scene/toml_value.hpp"

#include <utility>

#include "apps/scene/toml_nesting.hpp"

namespace app {

toml::table parse_toml(const std::string& text, const std::string& path) try {
  check_nesting(text, path);
  return toml::parse(text, path);
} catch (const toml::parse_error& error) {
  throw Rejected(Exit::data,
                 {place_of(error.source(), path), "not TOML", std::string(error.description()), "", ""});
}

Place place_of(const toml::source_region& source, const std::string& path) {
  return {path, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

std::optional<Value> value_of(const toml::node& node) {
  if (const auto* boolean = node.as_boolean()) return Value{boolean->get()};
  if (const auto* integer = node.as_integer()) return Value{integer->get()};
  if (const auto* number = node.as_floating_point()) return Value{number->get()};
  if (const auto* text = node.as_string()) return Value{text->get()};
  const auto* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  Value::List items;
  for (const toml::node& item : *array) {
    auto value = value_of(item);
    if (!value) return std::nullopt;
    items.push_back(std::move(*value));
  }
  return Value{std::move(items)};
}

bool stands_before(const Place& a, const Place& b) {
  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
}

}  // namespace app
