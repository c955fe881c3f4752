#pragma once

namespace app {

[[nodiscard]] const char* version();  ///< of the program, "0.1.0"

}  // namespace app
