#include "apps/system/interrupt.hpp"

#include <csignal>

namespace app {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int signal) {
  noted = 1;
  // A second Ctrl-C ends the program. A second SIGTERM does not: timeout and batch systems send it twice at
  // once.
  if (signal == SIGINT) std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
  std::signal(SIGUSR1, note_signal);
  pipe_before_ = std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
  std::signal(SIGPIPE, pipe_before_);
}

bool InterruptGuard::interrupted() const { return noted != 0; }

}  // namespace app
