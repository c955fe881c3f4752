/// How quantities read in the texts of errors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace specimen {

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
