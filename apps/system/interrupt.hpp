/// Ctrl-C ends a run in order.
#pragma once

namespace app {

/// While it lives, SIGINT, SIGTERM, and SIGUSR1, by which batch systems tell that time is nearly up, are only
/// noted; a second SIGINT ends the program at once. Nor does the program end because nobody reads any more
/// what it says.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;

 private:
  void (*pipe_before_)(int);
};

}  // namespace app
