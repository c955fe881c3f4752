/// This process and others: signals that end a run in order, the memory it may take, programs that it runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/// While it lives, SIGINT, SIGTERM, SIGHUP of a terminal that closes, and SIGUSR1, by which batch systems
/// tell that time is nearly up, are only noted; a third SIGINT ends the program at once. Nor does the program
/// end because nobody reads any more what it says.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;

 private:
  void (*hang_up_before_)(int);
  void (*pipe_before_)(int);
};

/// What a program may take [bytes]: what the machine has, or its container may use.
/// @param machine  with its swap space [bytes].   @param container  the file memory.max of the control group;
/// empty = none.
[[nodiscard]] std::uint64_t memory_to_take(std::uint64_t machine, const std::string& container);

/// From here on an allocation beyond the memory there is throws std::bad_alloc; without a limit the system
/// would end the program, or another one, without a word. Programs under a sanitizer, which lays out more
/// addresses than there is memory, keep no limit.
void limit_memory();

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
