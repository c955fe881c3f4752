/// Strains on the terminal.
#pragma once

#include <string>

namespace app {

/// "940.3e-6", and "2.313 %" from 1 % on.
[[nodiscard]] std::string strain_text(double strain);

}  // namespace app
