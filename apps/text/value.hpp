/// A value of a setting as scene files hold it.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace app {

/// Quantities are texts ("0.05 m/s"); a list holds values of one kind.
struct Value {
  using List = std::vector<Value>;
  std::variant<bool, std::int64_t, double, std::string, List> data;
  friend bool operator==(const Value&, const Value&) = default;
};

/// As TOML writes it, on one line.
[[nodiscard]] std::string toml_text(const Value& value);

}  // namespace app
