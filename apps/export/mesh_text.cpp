#include "apps/export/mesh_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <span>

namespace exchange {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  ///< [bytes]

}  // namespace

TextStream& TextStream::operator<<(std::string_view text) {
  text_.append(text);
  if (text_.size() >= piece) flush();
  return *this;
}

TextStream& TextStream::operator<<(std::int64_t number) {
  const fmt::format_int text(number);
  return *this << std::string_view(text.data(), text.size());
}

void TextStream::flush() {
  sink_(std::as_bytes(std::span(text_)));
  text_.clear();
}

void write_text(const std::string& path, const std::function<void(TextStream&)>& write) {
  specimen::replace_file(path, [&](const specimen::ByteSink& sink) {
    TextStream stream(sink);
    write(stream);
    stream.flush();
  });
}

std::string length_text(double length) { return fmt::format("{:.12g}", length); }

namespace {

/// The first `longest` bytes, less a character of UTF-8 that would be cut in two.
std::string cut(const std::string& name, std::size_t longest) {
  std::size_t end = std::min(name.size(), longest);
  while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end);
}

/// The name, or the name with the first number behind it that makes it new.
std::string made_new(const std::string& name, const std::vector<std::string>& taken, std::size_t longest) {
  std::string candidate = cut(name, longest);
  for (int number = 2; std::find(taken.begin(), taken.end(), candidate) != taken.end(); ++number) {
    const std::string ending = "_" + std::to_string(number);
    candidate = cut(name, longest - ending.size()) + ending;
  }
  return candidate;
}

template <class Clean>
std::vector<std::string> all_clean(const std::vector<std::string>& phases, std::size_t longest, Clean clean) {
  std::vector<std::string> names;
  for (const std::string& phase : phases) names.push_back(made_new(clean(phase), names, longest));
  return names;
}

bool is_ascii_letter_or_digit(unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; }

std::string capitals(const std::string& phase) {
  std::string name;
  for (const char c : phase) {
    const auto byte = static_cast<unsigned char>(c);
    name += is_ascii_letter_or_digit(byte) ? static_cast<char>(std::toupper(byte)) : '_';
  }
  const bool letter_first = !name.empty() && std::isupper(static_cast<unsigned char>(name.front())) != 0;
  return letter_first ? name : "PHASE_" + name;
}

std::string quotable(std::string phase) {
  for (char& c : phase)
    if (c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '_';
  return phase;
}

}  // namespace

std::vector<std::string> set_names(const std::vector<std::string>& phases) {
  return all_clean(phases, 80, capitals);
}

std::vector<std::string> group_names(const std::vector<std::string>& phases) {
  return all_clean(phases, 120, quotable);
}

}  // namespace exchange
