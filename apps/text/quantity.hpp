/// Quantities with units as people write them, "0.5 mm", "20 GPa", "45 %", and values of settings as
/// scenes have them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/text/complaint.hpp"

namespace app {

/// What a number measures; energy is that of an area, as of a crack. Everything inside the program is in SI
/// units (angles in rad).
enum class Dimension { ratio, length, area, pressure, angle, velocity, density, time, energy };

[[nodiscard]] std::string name(Dimension dimension);     ///< "length"
[[nodiscard]] std::string example(Dimension dimension);  ///< "0.5 mm"

[[nodiscard]] std::string si_unit(Dimension dimension);  ///< "m"; "1" for ratios

/// "mm", "m", "um" and the others that are understood; for ratios "%" and "microstrain", which may be left
/// out.
[[nodiscard]] std::vector<std::string> unit_names(Dimension dimension);

/// A value that is no quantity of the dimension at all: must be a length, e.g. "0.5 mm".
struct NoQuantity : Mistake {
  explicit NoQuantity(Dimension dimension, const std::string& how_to_cure = {});
};

/// A quantity in SI units. A unit is obligatory but for ratios (where "%" and "microstrain" are possible).
/// Decimal units shift the exponent before the one rounding to binary: "0.5 mm" is the double 0.5e-3.
/// @throws Mistake for text that is no number, for a missing, unknown or unfit unit, and for values that are
/// not finite or beyond the range of doubles.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension dimension);

/// The shortest text in a readable unit that parse_quantity reads back to the same double.
[[nodiscard]] std::string format_quantity(double value, Dimension dimension);

/// The value in the unit in which format_quantity() writes another one, with five digits.
[[nodiscard]] std::string format_like(double value, double other, Dimension dimension);

/// Whether a unit of this name measures the dimension.
[[nodiscard]] bool is_unit(std::string_view unit, Dimension dimension);

/// The shortest text that reads back to the same double; "0.0004", "2e-7", "nan".
[[nodiscard]] std::string format_number(double value);

/// The text of a finite value times ten to the `shift`, with the digits of the value: nothing is rounded.
[[nodiscard]] std::string format_shifted(double value, int shift);

/// Quantities are texts ("0.05 m/s"); a list holds values of one kind.
struct Value {
  using List = std::vector<Value>;
  std::variant<bool, std::int64_t, double, std::string, List> data;
  friend bool operator==(const Value&, const Value&) = default;
};

/// A text setting that was not given has no default that could be shown.
[[nodiscard]] bool is_empty_text(const Value& value);

/// As TOML writes it, on one line.
[[nodiscard]] std::string toml_text(const Value& value);

}  // namespace app
