/// Other programs, run to their end.
#pragma once

#include <string>
#include <vector>

namespace app {

/// What a program left.
struct ProgramOutcome {
  int code = 0;     ///< exit code; 128 + the signal that ended it
  std::string out;  ///< of its standard output
  std::string err;  ///< of its standard error
};

/// Run a program of PATH with an empty standard input.
/// @param words  its name and arguments, as they are: no shell sees them.
/// @throws Rejected (Exit::io) when there is no such program, or it cannot be started.
[[nodiscard]] ProgramOutcome run_other_program(const std::vector<std::string>& words);

/// Path of this program, for commands that others are to give.
[[nodiscard]] std::string this_program();

}  // namespace app
