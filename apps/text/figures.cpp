#include "apps/text/figures.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace output {
namespace {

constexpr std::string_view minus = "\u2212";
constexpr std::string_view dash = "\u2013";
constexpr std::string_view narrow_space = "\u202F";
constexpr std::string_view no_break_space = "\u00A0";

/// Thousands apart from five digits on, as ISO 80000-1 has it.
std::string group_thousands(const std::string& digits) {
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  if (whole < 5) return digits;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && i < whole && (whole - i) % 3 == 0) text += narrow_space;
    text += digits[i];
  }
  return text;
}

std::string superscript(int exponent) {
  static constexpr std::array<std::string_view, 10> figures{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += figures[static_cast<std::size_t>(c - '0')];
  return text;
}

/// Of a positive number; its exponent as it is after rounding to the digits.
struct Scientific {
  std::string mantissa;
  int exponent = 0;
};

Scientific scientific(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  return {text.substr(0, e), std::stoi(text.substr(e + 1))};
}

/// "1.25" of "1.2500".
std::string without_zeros(std::string digits) {
  if (digits.find('.') == std::string::npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

enum class Style { rounded, concise, power };

std::string figure(double value, int digits, Style style) {
  if (!std::isfinite(value)) return std::string(dash);
  if (value == 0) return "0";
  const auto shown = [style](const std::string& all) {
    return style == Style::rounded ? all : without_zeros(all);
  };
  const Scientific parts = scientific(std::abs(value), digits);
  const std::string sign(value < 0 ? minus : "");
  if (parts.exponent >= -3 && parts.exponent < 7)
    return sign + group_thousands(shown(
                      fmt::format("{:.{}f}", std::abs(value), std::max(0, digits - 1 - parts.exponent))));
  const std::string mantissa = shown(parts.mantissa), power = "10" + superscript(parts.exponent);
  if (style == Style::power && mantissa == "1") return sign + power;
  return fmt::format("{}{}{}×{}{}", sign, mantissa, no_break_space, no_break_space, power);
}

}  // namespace

std::string exact(double value) {
  if (std::isnan(value)) return "nan";  // the sign of a NaN says nothing
  return fmt::format("{}", value);
}

std::string rounded(double value, int digits) { return figure(value, digits, Style::rounded); }

std::string concise(double value, int digits) { return figure(value, digits, Style::concise); }

std::string concise_power(double value, int digits) { return figure(value, digits, Style::power); }

std::string with_decimals(double value, int decimals) {
  if (!std::isfinite(value)) return std::string(dash);
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !is_zero ? std::string(minus) : "") + group_thousands(text);
}

std::string grouped(std::int64_t value) { return with_decimals(static_cast<double>(value), 0); }

std::string percent(double share, int decimals) {
  return with_decimals(100 * share, decimals) + std::string(no_break_space) + "%";
}

}  // namespace output

namespace app {

std::string strain_text(double strain) {
  return strain < 0.01 ? fmt::format("{:.4g}e-6", 1e6 * strain) : fmt::format("{:.4g} %", 100 * strain);
}

}  // namespace app
