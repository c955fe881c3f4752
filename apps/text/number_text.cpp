#include "apps/text/number_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace app {
namespace {

/// Digits and decimal exponent of the shortest scientific text: value = 0.d1d2d3... x 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Decimal shortest(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value),
                                 std::chars_format::scientific)
                       .ptr;
  const std::string text(buffer.data(), end);
  const std::size_t e = text.find('e');
  Decimal decimal{std::signbit(value), text.substr(0, 1), std::atoi(text.c_str() + e + 1) + 1};
  if (e > 2) decimal.digits += text.substr(2, e - 2);
  return decimal;
}

std::string fixed_text(const Decimal& d) {
  const auto n = static_cast<int>(d.digits.size());
  if (d.exponent <= 0) return "0." + std::string(static_cast<std::size_t>(-d.exponent), '0') + d.digits;
  if (d.exponent >= n) return d.digits + std::string(static_cast<std::size_t>(d.exponent - n), '0');
  return d.digits.substr(0, static_cast<std::size_t>(d.exponent)) + "." +
         d.digits.substr(static_cast<std::size_t>(d.exponent));
}

std::string scientific_text(const Decimal& d) {
  const std::string decimals = d.digits.size() > 1 ? "." + d.digits.substr(1) : "";
  return fmt::format("{}{}e{}", d.digits[0], decimals, d.exponent - 1);
}

/// Without an exponent unless that costs more than three letters.
std::string text_of(const Decimal& d) {
  if (d.digits == "0") return "0";
  const std::string scientific = scientific_text(d);
  const bool huge = std::abs(d.exponent) > 30;  // never spelled out
  const std::string fixed = huge ? "" : fixed_text(d);
  const bool plain = !huge && fixed.size() <= scientific.size() + 3;
  return (d.negative ? "-" : "") + (plain ? fixed : scientific);
}

}  // namespace

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return format_shifted(value, 0);
}

std::string format_shifted(double value, int shift) {
  Decimal decimal = shortest(value);
  decimal.exponent += shift;
  return text_of(decimal);
}

}  // namespace app
