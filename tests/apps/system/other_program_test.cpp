#include "apps/system/processes.hpp"

#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"

namespace other_program_test {

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

TEST(OtherProgram, ThatIsNotThereIsNamed) {
  try {
    (void)run_other_program({"no_such_program"});
    FAIL() << "nothing was thrown";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::io);
    EXPECT_STREQ(rejected.what(),
                 "no_such_program: No such file or directory; must be a program in the PATH");
  }
}

TEST(OtherProgram, TellsWhereThisOneIs) {
  const std::string path = app::this_program();
  EXPECT_EQ(path.front(), '/');
  EXPECT_NE(path.find("_tests"), std::string::npos);
}

}  // namespace other_program_test
