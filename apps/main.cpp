#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "apps/console.hpp"
#include "apps/memory_limit.hpp"
#include "apps/program.hpp"
#ifdef MESOPIX_EVIDENCE
#include "apps/evidence_commands.hpp"
#endif

int main(int argc, char** argv) {
  app::limit_memory();
  app::Console console{std::cout, std::cerr, isatty(STDERR_FILENO) != 0, false, {}};
  const std::vector<std::string> arguments(argv + 1, argv + argc);
#ifdef MESOPIX_EVIDENCE
  const app::MoreCommands more = app::evidence_commands();
#else
  const app::MoreCommands more;
#endif
  return static_cast<int>(app::run_program(arguments, console, more));
}
