#include "specimen/body/notes.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace specimen {
namespace {

std::string text_of(double value, std::chars_format format, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
  return {text.data(), end.ptr};
}

}  // namespace

std::string grouped(std::int64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t left = digits.size() - i;
    if (left % 3 == 0 && !text.empty() && text.back() != '-') text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::int64_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string share_text(double part, double whole) {
  const double percent = whole > 0 ? 100 * part / whole : 0;
  if (percent == 0) return "0 %";
  if (percent < 0.1) return text_of(percent, std::chars_format::general, 1) + " %";
  return text_of(percent, std::chars_format::fixed, 1) + " %";
}

std::string length_text(double metres) { return short_number(metres * 1e3) + " mm"; }
std::string area_text(double square_metres) {
  return text_of(square_metres * 1e6, std::chars_format::general, 3) + " mm2";
}
std::string short_number(double value) { return text_of(value, std::chars_format::general, 4); }

}  // namespace specimen
