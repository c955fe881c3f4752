/// Whole files as text.
#pragma once

#include <string>

namespace app {

/// @throws Rejected (Exit::io) naming the file and the reason of the system.
[[nodiscard]] std::string read_text_file(const std::string& path);

}  // namespace app
