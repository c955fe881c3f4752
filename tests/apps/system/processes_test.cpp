#include "apps/system/processes.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "apps/text/complaint.hpp"

namespace processes_test {

using app::memory_to_take;
using app::run_other_program;

TEST(OtherProgram, LeavesItsExitCodeAndBothStreams) {
  const auto outcome = run_other_program({"sh", "-c", "echo one; echo two >&2; exit 3"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "one\n");
  EXPECT_EQ(outcome.err, "two\n");
}

TEST(OtherProgram, MayWriteMoreThanAPipeHolds) {
  const auto outcome =
      run_other_program({"sh", "-c", "head -c 300000 /dev/zero >&2; head -c 200000 /dev/zero"});
  EXPECT_EQ(outcome.out.size(), 200'000);
  EXPECT_EQ(outcome.err.size(), 300'000);
}

TEST(OtherProgram, GetsItsWordsAsTheyAre) {
  EXPECT_EQ(run_other_program({"printf", "%s|", "a b", "$HOME", "'"}).out, "a b|$HOME|'|");
}

TEST(OtherProgram, ReadsNothing) { EXPECT_EQ(run_other_program({"cat"}).out, ""); }

TEST(OtherProgram, ThatASignalEndedTellsWhich) {
  EXPECT_EQ(run_other_program({"sh", "-c", "kill -9 $$"}).code, 137);
}

/// In a PATH whose folders may be entered: the system would else say so of one that may not.
TEST(OtherProgram, ThatIsNotThereIsNamed) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", "/nothing/there", 1);
  try {
    (void)run_other_program({"no_such_program"});
    FAIL() << "nothing was thrown";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::io);
    EXPECT_STREQ(rejected.what(),
                 "no_such_program: No such file or directory; must be a program in the PATH");
  }
  ::setenv("PATH", before.c_str(), 1);
}

TEST(OtherProgram, TellsWhereThisOneIs) {
  const std::string path = app::this_program();
  EXPECT_EQ(path.front(), '/');
  EXPECT_NE(path.find("_tests"), std::string::npos);
}

TEST(MemoryLimit, IsWhatTheMachineOrTheContainerHas) {
  EXPECT_EQ(memory_to_take(1000, ""), 1000);
  EXPECT_EQ(memory_to_take(1000, "max"), 1000);
  EXPECT_EQ(memory_to_take(1000, "400"), 400);
  EXPECT_EQ(memory_to_take(1000, "4000"), 1000);
  EXPECT_EQ(memory_to_take(1000, "99999999999999999999999"), 1000);
}

#ifdef NDEBUG  // presets of sanitizers, under which there is no limit, are for debugging
TEST(MemoryLimitDeathTest, TurnsTooLargeAWishIntoAnError) {
  const auto ask = [] {
    app::limit_memory();
    try {
      // Untouched, so that nothing but the limit stands in the way.
      for (int i = 0; i < 1'000'000; ++i) (void)new char[std::size_t{1} << 28U];
    } catch (const std::bad_alloc&) {
      std::exit(3);
    }
    std::exit(4);
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(ask(), testing::ExitedWithCode(3), "");
}
#endif

TEST(InterruptGuard, NotesTwoOfThemAndEndsAtTheThird) {
  const app::InterruptGuard guard;
  EXPECT_FALSE(guard.interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(guard.interrupted());
  std::raise(SIGINT);  // while what there is so far is written
  EXPECT_TRUE(guard.interrupted());
  EXPECT_EQ(std::signal(SIGINT, SIG_IGN), SIG_DFL);  // a third one would have ended the program
}

TEST(InterruptGuard, NotesATerminalThatCloses) {
  {
    const app::InterruptGuard guard;
    std::raise(SIGHUP);
    EXPECT_TRUE(guard.interrupted());
  }
  std::signal(SIGHUP, SIG_IGN);
  {
    const app::InterruptGuard guard;
    std::raise(SIGHUP);
    EXPECT_FALSE(guard.interrupted()) << "as nohup asks for";
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
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

}  // namespace processes_test
