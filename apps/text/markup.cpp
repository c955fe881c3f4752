#include "apps/text/markup.hpp"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/text/utf8.hpp"

namespace output {
namespace {

constexpr std::string_view replacement = "\uFFFD";

std::string_view escaped_ascii(char c, std::string_view as_is) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    case '\n':
    case '\t':
      return as_is;
    default:
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? replacement : as_is;
  }
}

}  // namespace

std::string escape(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = app::character_length(text);
    const std::string_view as_is = text.substr(0, length);
    if (length == 0)
      escaped += replacement;
    else
      escaped += length == 1 ? escaped_ascii(text[0], as_is) : as_is;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return escaped;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[triple >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string png_address(std::string_view png) { return "data:image/png;base64," + base64(png); }

}  // namespace output

namespace app {

std::string json_text(const nlohmann::ordered_json& json) {
  std::istringstream written(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  std::string text;
  for (std::string line; std::getline(written, line);) text += escaped_controls(line) + '\n';
  return text;
}

}  // namespace app
