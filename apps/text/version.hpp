/// Version of the program, and how it was built.
#pragma once

namespace app {

[[nodiscard]] const char* version();  ///< of the program, "0.1.0"

/// How the program was built.
struct Build {
  const char* compiler = "";  ///< "GCC 12.2.0"
  const char* type = "";      ///< of CMake: "Release", "Debug"
  bool sanitized = false;     ///< looks after itself at run time, and is slow
};

[[nodiscard]] Build build();

}  // namespace app
