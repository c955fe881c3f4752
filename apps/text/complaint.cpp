#include "apps/text/complaint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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

/// Bytes of the character of UTF-8 that stands at a place; 0 where there is none.
std::size_t character_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto length = static_cast<std::size_t>(sequence_length(byte(at)));
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return length > 1 && !fits_second(byte(at), byte(at + 1)) ? 0 : length;
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
    const std::size_t length = character_length(text, at);
    const std::string_view character = std::string_view(text).substr(at, std::max<std::size_t>(length, 1));
    const int code = length == 0 ? -1 : static_cast<int>(code_point(character));
    if (code < 0 || is_control(static_cast<unsigned>(code)))
      result += replaced(code, character);
    else
      result += character;
    at += character.size();
  }
  return result;
}

/// A part of a complaint, cut where it is longer than anybody reads.
std::string shown(const std::string& part) {
  constexpr std::size_t longest = 2000;
  std::string text = printable(part.substr(0, longest));
  return part.size() > longest ? text + "..." : text;
}

std::string all_lines(const std::vector<Complaint>& complaints) {
  std::string lines;
  for (const Complaint& complaint : complaints) {
    if (!lines.empty()) lines += '\n';
    lines += text(complaint);
  }
  return lines;
}

}  // namespace

std::string text(const Place& place) {
  if (place.line == 0) return place.file;
  return fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

std::string text(const Complaint& complaint) {
  std::string line;
  const char* separator = ": ";
  const auto append = [&](const std::string& part) {
    if (part.empty()) return;
    if (!line.empty()) line += separator;
    line += shown(part);
  };
  append(text(complaint.place));
  append(complaint.field);
  const std::size_t subject = line.size();
  for (const std::string* part : {&complaint.value, &complaint.defect, &complaint.allowed, &complaint.cure}) {
    if (line.size() > subject) separator = "; ";
    append(*part);
  }
  return line;
}

Complaint complaint(std::string field, std::string value, std::string allowed, std::string cure) {
  Complaint result;
  result.field = std::move(field);
  result.value = std::move(value);
  result.allowed = std::move(allowed);
  result.cure = std::move(cure);
  return result;
}

namespace {

std::string with_two_dashes(std::string name) { return "--" + name; }

std::string (*spelling_of_options)(std::string) = &with_two_dashes;

}  // namespace

std::string option_name(const std::string& name) { return spelling_of_options(name); }

void call_options_by(std::string (*spelling)(std::string name)) { spelling_of_options = spelling; }

std::string text(const Suggestion& suggestion) {
  return suggestion.meant.empty() ? suggestion.otherwise : "did you mean " + suggestion.meant + "?";
}

Complaint unknown_key(Place place, std::string key, const Suggestion& suggestion) {
  return {std::move(place), std::move(key), "", "", text(suggestion), "unknown key", suggestion.meant};
}

Rejected::Rejected(Exit exit_code, std::vector<Complaint> all)
    : std::runtime_error(all_lines(all)), code(exit_code), complaints(std::move(all)) {}

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
    const std::size_t length = character_length(text, at);
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
