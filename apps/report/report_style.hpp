/// How the report looks.
#pragma once

#include <string>

namespace output {

/// Style sheet: light and dark by the reader's setting, phones, print.
[[nodiscard]] std::string report_style();

}  // namespace output
