/// How figures read in the notes of a conversion.
#pragma once

#include <cstdint>
#include <string>

namespace specimen {

/// "1,234,567".
[[nodiscard]] std::string grouped(std::int64_t count);
/// "1 island", "1,234 islands".
[[nodiscard]] std::string counted(std::int64_t count, const std::string& noun);
/// "3.2 %" of a share; "0.004 %" where one decimal would say nothing.
[[nodiscard]] std::string share_text(double part, double whole);
/// "0.5 mm" of metres, four significant digits.
[[nodiscard]] std::string length_text(double metres);
/// "2.5 mm2" of square metres, three significant digits.
[[nodiscard]] std::string area_text(double square_metres);
/// Four significant digits, a point whatever the locale.
[[nodiscard]] std::string short_number(double value);

}  // namespace specimen
