/// The one exception that the specimen library throws for a user's mistake.
/// How quantities read in the texts of errors.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace specimen {

/// What kind of mistake it was; the program maps it to its exit code.
enum class Fault {
  data,   ///< a value, a picture or a file's content is not usable
  write,  ///< a file could not be read from or written to disk
};

/// A user's mistake: which field, the value met, what is allowed, and how to cure it.
/// what() reads "field: value; allowed; cure" with the empty parts left out.
struct Error : std::runtime_error {
  Error(std::string field_name, std::string value_met, std::string what_is_allowed,
        std::string how_to_cure = {}, Fault kind = Fault::data);

  std::string field;    ///< the option or the file that is at fault, e.g. "generate.fraction"
  std::string value;    ///< the value met, with its unit
  std::string allowed;  ///< what would have been accepted
  std::string cure;     ///< what to try
  Fault fault;
};

/// "12.5": at most six significant digits, a point whatever the locale.
[[nodiscard]] std::string number(double value);
/// "12.5 mm" of metres.
[[nodiscard]] std::string millimetres(double metres);
/// "12.5 %" of a share.
[[nodiscard]] std::string percent(double share);
/// "a, b, c".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);
/// The name nearest to a misspelt one by edit distance, ignoring case; empty when none is near.
[[nodiscard]] std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace specimen
