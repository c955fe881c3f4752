#include "apps/text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace app {
namespace {

/// Length of the UTF-8 sequence that begins with a byte; 0 = none does.
int sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// Overlong forms, surrogates and code points beyond the last one show in the second byte.
bool fits_second(unsigned char first, unsigned char second) {
  if (first == 0xE0) return second >= 0xA0;
  if (first == 0xED) return second < 0xA0;
  if (first == 0xF0) return second >= 0x90;
  return first != 0xF4 || second < 0x90;
}

/// Code point of a character of these bytes.
unsigned code_point(std::string_view character) {
  if (character.size() == 1) return static_cast<unsigned char>(character[0]);
  unsigned code = static_cast<unsigned char>(character[0]) & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

/// What moves the cursor, colours or clears a terminal, and what turns the direction of a line round.
bool is_control(unsigned code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C ||
         (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// The text with `replaced` for each control character (given its code) and each byte that is no text (given
/// -1).
template <class Replaced>
std::string without_controls(const std::string& text, Replaced replaced) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = std::string_view(text).substr(at);
    const std::size_t length = character_length(rest);
    const std::string_view character = rest.substr(0, std::max<std::size_t>(length, 1));
    const int code = length == 0 ? -1 : static_cast<int>(code_point(character));
    if (code < 0 || is_control(static_cast<unsigned>(code)))
      result += replaced(code, character);
    else
      result += character;
    at += character.size();
  }
  return result;
}

}  // namespace

std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto length = text.empty() ? 0 : static_cast<std::size_t>(sequence_length(byte(0)));
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return length > 1 && !fits_second(byte(0), byte(1)) ? 0 : length;
}

std::string escaped_controls(const std::string& text) {
  return without_controls(text, [](int code, std::string_view bytes) {
    return code < 0 ? std::string(bytes) : fmt::format("\\u{:04X}", code);
  });
}

std::string quoted(const std::string& text) {
  std::string marked;
  for (const char c : text) {
    if (c == '"' || c == '\\')
      marked += {'\\', c};
    else if (c == '\n')
      marked += "\\n";
    else if (c == '\t')
      marked += "\\t";
    else
      marked += c;
  }
  return '"' + escaped_controls(marked) + '"';
}

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(std::string_view(text).substr(at));
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string printable(const std::string& text) {
  return without_controls(text, [](int, std::string_view) { return "?"; });
}

std::string printable_lines(const std::string& text) {
  return without_controls(text, [](int code, std::string_view) { return code == '\n' ? "\n" : "?"; });
}

}  // namespace app
