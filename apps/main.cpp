#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "apps/command/program.hpp"
#include "apps/evidence_commands.hpp"
#include "apps/system/processes.hpp"
#include "apps/system/terminal.hpp"

namespace {

/// The number of a stream that is closed would go to the next file, which would then hold what is printed. In
/// its place stands one that cannot be written.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      (void)open("/dev/null", O_RDONLY);  // takes the lowest number that is free
}

}  // namespace

int main(int argc, char** argv) {
  fill_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of its size is an error as any other
  app::limit_memory();
  const app::Terminal err = app::terminal_at(STDERR_FILENO);
  app::Console console{
      std::cout, std::cerr, err.animated, false, {}, err.coloured, app::terminal_at(STDOUT_FILENO).coloured};
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  return static_cast<int>(app::run_program(arguments, console, app::evidence_commands()));
}
