#include "apps/system/processes.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace interrupt_test {

TEST(InterruptGuard, NotesTheFirstSignalOnly) {
  const app::InterruptGuard guard;
  EXPECT_FALSE(guard.interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(guard.interrupted());
  EXPECT_EQ(std::signal(SIGINT, SIG_IGN), SIG_DFL);  // a second one would have ended the program
}

// As timeout(1) sends it: to the program, and to its group.
TEST(InterruptGuard, OutlivesASecondSigterm) {
  const app::InterruptGuard guard;
  std::raise(SIGTERM);
  std::raise(SIGTERM);
  EXPECT_TRUE(guard.interrupted());
}

TEST(InterruptGuard, ForgetsEarlierSignals) {
  {
    const app::InterruptGuard guard;
    std::raise(SIGTERM);
    EXPECT_TRUE(guard.interrupted());
  }
  const app::InterruptGuard guard;
  EXPECT_FALSE(guard.interrupted());
}

TEST(InterruptGuard, GoesOnWhenNobodyReadsAnyMore) {
  {
    const app::InterruptGuard guard;
    std::raise(SIGPIPE);
    EXPECT_FALSE(guard.interrupted());
  }
  EXPECT_EQ(std::signal(SIGPIPE, SIG_DFL), SIG_DFL) << "only as long as it lives";
}

}  // namespace interrupt_test
