#include "apps/complaint.hpp"

#include <fmt/format.h>

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

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

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
    line += printable(part);
  };
  append(text(complaint.place));
  append(complaint.field);
  const std::size_t subject = line.size();
  for (const std::string* part : {&complaint.value, &complaint.allowed, &complaint.cure}) {
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

Rejected::Rejected(Exit exit_code, std::vector<Complaint> all)
    : std::runtime_error(all_lines(all)), code(exit_code), complaints(std::move(all)) {}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (is_control(c))
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

bool is_utf8(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto length = static_cast<std::size_t>(sequence_length(byte(at)));
    if (length == 0 || at + length > text.size()) return false;
    for (std::size_t i = at + 1; i < at + length; ++i)
      if ((byte(i) & 0xC0) != 0x80) return false;
    if (length > 1 && !fits_second(byte(at), byte(at + 1))) return false;
    at += length;
  }
  return true;
}

std::string printable(std::string text) {
  for (char& c : text)
    if (is_control(c)) c = '?';
  return text;
}

}  // namespace app
