#include "apps/text/quantity.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

/// A dimension in words, in the order of the enumeration.
struct InWords {
  const char *name, *example;
};

const InWords& in_words(Dimension dimension) {
  static constexpr std::array<InWords, 9> all{{{"number", "0.45"},
                                               {"length", "0.5 mm"},
                                               {"area", "2 mm2"},
                                               {"pressure", "20 GPa"},
                                               {"angle", "50 deg"},
                                               {"velocity", "0.05 m/s"},
                                               {"density", "2400 kg/m3"},
                                               {"time", "0.1 ms"},
                                               {"energy of an area", "60 J/m2"}}};
  return all[static_cast<std::size_t>(dimension)];
}

constexpr double degree = std::numbers::pi / 180;

/// A unit is `factor` times ten to the `exponent` SI units; the factor differs from 1 for degrees, minutes
/// and hours alone.
struct Unit {
  Dimension dimension;
  std::string_view name;
  int exponent;
  bool written;  ///< chosen when a quantity is written; the others are only understood
  double factor = 1;
};

/// Of those that are written, the first one wins where two give texts of one length.
constexpr std::array units{
    Unit{Dimension::ratio, "%", -2, false},
    Unit{Dimension::ratio, "microstrain", -6, false},
    Unit{Dimension::length, "mm", -3, true},
    Unit{Dimension::length, "m", 0, true},
    Unit{Dimension::length, "um", -6, true},
    Unit{Dimension::length, "cm", -2, false},
    Unit{Dimension::length, "µm", -6, false},
    Unit{Dimension::area, "mm2", -6, true},
    Unit{Dimension::area, "m2", 0, true},
    Unit{Dimension::area, "cm2", -4, false},
    Unit{Dimension::area, "mm^2", -6, false},
    Unit{Dimension::area, "cm^2", -4, false},
    Unit{Dimension::area, "m^2", 0, false},
    Unit{Dimension::pressure, "MPa", 6, true},
    Unit{Dimension::pressure, "GPa", 9, true},
    Unit{Dimension::pressure, "kPa", 3, true},
    Unit{Dimension::pressure, "Pa", 0, true},
    Unit{Dimension::pressure, "N/mm2", 6, false},
    Unit{Dimension::angle, "deg", 0, true, degree},
    Unit{Dimension::angle, "rad", 0, true},
    Unit{Dimension::angle, "°", 0, false, degree},
    Unit{Dimension::velocity, "m/s", 0, true},
    Unit{Dimension::velocity, "mm/s", -3, false},
    Unit{Dimension::density, "kg/m3", 0, true},
    Unit{Dimension::density, "kg/m^3", 0, false},
    Unit{Dimension::density, "g/cm3", 3, false},
    Unit{Dimension::time, "s", 0, true},
    Unit{Dimension::time, "ms", -3, true},
    Unit{Dimension::time, "us", -6, true},
    Unit{Dimension::time, "µs", -6, false},
    Unit{Dimension::time, "min", 0, false, 60},
    Unit{Dimension::time, "h", 0, false, 3600},
    Unit{Dimension::energy, "J/m2", 0, true},
    Unit{Dimension::energy, "J/m^2", 0, false},
    Unit{Dimension::energy, "N/m", 0, false},
    Unit{Dimension::energy, "N/mm", 3, false},
};

const Unit* find_unit(std::string_view name, Dimension dimension) {
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) {
    return unit.dimension == dimension && unit.name == name;
  });
  return found == units.end() ? nullptr : found;
}

bool known_anywhere(std::string_view name) {
  return std::any_of(units.begin(), units.end(), [&](const Unit& unit) { return unit.name == name; });
}

/// A decimal number cut from the front of a text: "[-+]digits[.digits][e[-+]digits]", then the rest.
struct Numeral {
  std::string mantissa;  ///< without a leading "+"
  long exponent = 0;
  std::string_view rest;
};

std::optional<Numeral> read_numeral(std::string_view text) {
  const bool has_plus = text.starts_with('+');
  if (has_plus) text.remove_prefix(1);
  const std::size_t sign = !has_plus && text.starts_with('-') ? 1 : 0;
  if (text.substr(sign).find_first_of(".0123456789") != 0) return std::nullopt;  // "inf" and "nan" are words
  double ignored = 0;
  const char* end = std::from_chars(text.data(), text.data() + text.size(), ignored).ptr;
  const auto size = static_cast<std::size_t>(end - text.data());
  if (size == 0) return std::nullopt;
  const std::size_t e = std::min(text.find_first_of("eE"), size);
  Numeral numeral{std::string(text.substr(0, e)), 0, trimmed(text.substr(size))};
  if (e == size) return numeral;
  const char* exponent = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
  const bool fits = std::from_chars(exponent, end, numeral.exponent).ec == std::errc();
  constexpr long beyond = 999999;  // out of the range of numbers anyway
  numeral.exponent =
      !fits ? (text[e + 1] == '-' ? -beyond : beyond) : std::clamp(numeral.exponent, -beyond, beyond);
  return numeral;
}

double to_double(const Numeral& numeral, int shift) {
  const std::string decimal = fmt::format("{}e{}", numeral.mantissa, numeral.exponent + shift);
  double value = 0;
  const auto [end, error] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  if (error != std::errc() || !std::isfinite(value)) throw Mistake("beyond the range of numbers");
  return value;
}

[[noreturn]] void refuse_text(std::string_view text, Dimension dimension) {
  const std::string start(text.substr(0, text.find_first_of(" \t")));
  const std::string bare = start.substr(start.find_first_not_of("+-") == 1 ? 1 : 0, 3);
  if (bare == "nan" || bare == "inf" || bare == "NaN" || bare == "Inf" || bare == "NAN" || bare == "INF")
    throw Mistake("must be a finite number");
  throw NoQuantity(dimension);
}

[[noreturn]] void refuse_unit(std::string_view unit, Dimension dimension) {
  if (unit.front() == ',') throw NoQuantity(dimension, "write the decimals behind a point");
  const bool could_be_a_unit = std::isalpha(static_cast<unsigned char>(unit.front())) != 0 || unit == "%";
  if (!could_be_a_unit || known_anywhere(unit)) throw NoQuantity(dimension);
  const std::vector<std::string> names = unit_names(dimension);
  throw Mistake(fmt::format("unknown unit {}, allowed are {}", unit, listed(names, "and")),
                did_you_mean(unit, names));
}

/// A number of `unit.factor` units whose text reads back to the value; empty when there is none.
std::string factored_text(double value, const Unit& unit) {
  for (int precision = 1; precision <= 17; ++precision) {
    const double rounded =
        std::strtod(fmt::format("{:.{}g}", value / unit.factor, precision).c_str(), nullptr);
    if (rounded * unit.factor == value) return format_number(rounded);
  }
  return {};
}

std::string number_in(double value, const Unit& unit) {
  if (unit.factor != 1) return factored_text(value, unit);
  return format_shifted(value, -unit.exponent);
}

/// The unit in which the text of the value is shortest.
const Unit& readable_unit(double value, Dimension dimension) {
  const Unit* best = nullptr;
  std::size_t least = 0;
  for (const Unit& unit : units) {
    if (unit.dimension != dimension || !unit.written) continue;
    const std::string number = number_in(value, unit);
    const std::size_t length = number.size() + unit.name.size();
    if (number.empty() || (best != nullptr && length >= least)) continue;
    best = &unit;
    least = length;
  }
  return *best;
}

}  // namespace

std::vector<std::string> unit_names(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : units)
    if (unit.dimension == dimension) names.emplace_back(unit.name);
  return names;
}

std::string name(Dimension dimension) { return in_words(dimension).name; }

std::string si_unit(Dimension dimension) {
  if (dimension == Dimension::ratio) return "1";
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) {
    return unit.dimension == dimension && unit.exponent == 0 && unit.factor == 1;
  });
  return std::string(found->name);
}

std::string example(Dimension dimension) { return in_words(dimension).example; }

NoQuantity::NoQuantity(Dimension dimension, const std::string& how_to_cure)
    : Mistake(fmt::format("must be {} {}, e.g. {}",
                          dimension == Dimension::area || dimension == Dimension::angle ? "an" : "a",
                          name(dimension),
                          dimension == Dimension::ratio ? example(dimension) : quoted(example(dimension))),
              how_to_cure) {}

bool is_unit(std::string_view unit, Dimension dimension) { return find_unit(unit, dimension) != nullptr; }

double parse_quantity(std::string_view text, Dimension dimension) {
  const std::string_view cut = trimmed(text);
  const std::optional<Numeral> numeral = read_numeral(cut);
  if (!numeral) refuse_text(cut, dimension);
  if (numeral->rest.empty()) {
    if (dimension == Dimension::ratio) return to_double(*numeral, 0);
    throw Mistake("needs a unit", "write e.g. " + quoted(example(dimension)));
  }
  const Unit* unit = find_unit(numeral->rest, dimension);
  if (unit == nullptr) refuse_unit(numeral->rest, dimension);
  return to_double(*numeral, unit->exponent) * unit->factor;
}

std::string format_quantity(double value, Dimension dimension) {
  if (dimension == Dimension::ratio) return format_number(value);
  const Unit& unit = readable_unit(value, dimension);
  return fmt::format("{} {}", number_in(value, unit), unit.name);
}

std::string format_like(double value, double other, Dimension dimension) {
  const Unit& unit = readable_unit(other, dimension);
  return fmt::format("{:.5g} {}", value / (std::pow(10, unit.exponent) * unit.factor), unit.name);
}

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

bool is_empty_text(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  return text != nullptr && text->empty();
}

std::string toml_text(const Value& value) { return std::visit(Writer{}, value.data); }

}  // namespace app
