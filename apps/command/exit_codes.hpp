/// What the exit codes of the program mean, in words.
#pragma once

#include <string>
#include <vector>

#include "apps/text/complaint.hpp"

namespace app {

struct ExitMeaning {
  Exit code;
  const char* name;   ///< in sysexits.h; empty where it has none
  const char* brief;  ///< "wrong usage"
  const char* whole;  ///< a sentence or two
};

/// Every exit code, the smallest first.
[[nodiscard]] const std::vector<ExitMeaning>& exit_meanings();

/// "0 done, 64 wrong usage, ...", in lines of less than 100 letters.
[[nodiscard]] std::string exit_summary();

}  // namespace app
