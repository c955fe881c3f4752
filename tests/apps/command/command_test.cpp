#include "apps/command/command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace command_test {

TEST(ExitCodes, EachHasItsMeaningOnceTheSmallestFirst) {
  std::vector<int> codes;
  for (const app::ExitMeaning& meaning : app::exit_meanings()) {
    codes.push_back(static_cast<int>(meaning.code));
    EXPECT_EQ(std::string(meaning.name).rfind("EX_", 0), 0u);
    EXPECT_EQ(std::string(meaning.whole).back(), '.') << meaning.whole;
  }
  EXPECT_THAT(codes, testing::ElementsAre(0, 64, 65, 70, 74, 75));
}

TEST(ExitCodes, AreSummedUpInLinesThatFit) {
  const std::string text = app::exit_summary();
  EXPECT_EQ(text.rfind("0 done, 64 wrong usage, 65 ", 0), 0u) << text;
  EXPECT_THAT(text, testing::EndsWith("75 interrupted with what was computed kept"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 100u) << line;
}

}  // namespace command_test
