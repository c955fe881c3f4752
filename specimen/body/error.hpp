/// The exception of the specimen library, and the format of quantities in its messages.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace specimen {

/// Kind of an error; the program derives its exit code from it.
enum class Fault {
  data,   ///< a value, a picture or the content of a file is invalid
  write,  ///< a file could not be read from or written to disk
};

/// A user's mistake: the field, its value, what is allowed, and how to correct it.
/// what() reads "field: value; allowed; cure" without the empty parts. Numbers carry their unit, e.g.
/// "generate.gap: -1 mm; must be >= 0".
struct Error : std::runtime_error {
  Error(std::string field_name, std::string value_met, std::string what_is_allowed,
        std::string how_to_cure = {}, Fault kind = Fault::data);

  std::string field;    ///< the option or file at fault, e.g. "generate.fraction"
  std::string value;    ///< the value found, with its unit
  std::string allowed;  ///< what is accepted instead
  std::string cure;     ///< what to try
  Fault fault;          ///< kind of the error
};

/// A number with at most six significant digits and a decimal point in every locale, e.g. "12.5".
[[nodiscard]] std::string number(double value);
/// A length in mm, e.g. "12.5 mm".   @param metres  length [m].
[[nodiscard]] std::string millimetres(double metres);
/// A share in per cent, e.g. "12.5 %".   @param share  [-].
[[nodiscard]] std::string percent(double share);
/// Names separated by commas: "a, b, c".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);
/// The name closest to a misspelt one by edit distance, ignoring case; empty if none is close.
[[nodiscard]] std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace specimen
