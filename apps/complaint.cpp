#include "apps/complaint.hpp"

#include <fmt/format.h>

namespace app {
namespace {

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

std::string printable(std::string text) {
  for (char& c : text)
    if (is_control(c)) c = '?';
  return text;
}

}  // namespace app
