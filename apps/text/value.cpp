#include "apps/text/value.hpp"

#include <fmt/format.h>

#include "apps/text/complaint.hpp"
#include "apps/text/number_text.hpp"

namespace app {
namespace {

struct Writer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return format_number(value); }
  std::string operator()(const std::string& value) const { return quoted(value); }
  std::string operator()(const Value::List& items) const {
    std::string text;
    for (const Value& item : items) {
      if (!text.empty()) text += ", ";
      text += toml_text(item);
    }
    return fmt::format("[{}]", text);
  }
};

}  // namespace

std::string toml_text(const Value& value) { return std::visit(Writer{}, value.data); }

}  // namespace app
