/// The shortest decimal text of a double.
#pragma once

#include <string>

namespace app {

/// The shortest text that reads back to the same double; "0.0004", "2e-7", "nan".
[[nodiscard]] std::string format_number(double value);

/// The text of a finite value times ten to the `shift`, with the digits of the value: nothing is rounded.
[[nodiscard]] std::string format_shifted(double value, int shift);

}  // namespace app
