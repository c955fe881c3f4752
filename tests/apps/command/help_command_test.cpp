#include "apps/command/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/program_in_folder.hpp"

namespace help_command_test {

using app::Exit;

class HelpCommand : public test::ProgramInFolder {};

TEST_F(HelpCommand, SaysWhatTheOptionSays) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{}, {"simulate"}, {"study"}, {"study", "submit"}, {"help"}}) {
    std::vector<std::string> asked = words;
    asked.insert(asked.begin(), "help");
    ASSERT_EQ(run(asked), Exit::ok) << err_.str();
    const std::string told = out_.str();
    asked = words;
    asked.emplace_back("--help");
    ASSERT_EQ(run(asked), Exit::ok);
    EXPECT_EQ(told, out_.str());
    EXPECT_THAT(told, testing::HasSubstr("Usage: mesopix"));
  }
}

TEST_F(HelpCommand, RefusesCommandsThatAreNone) {
  EXPECT_EQ(run({"help", "simulte"}), Exit::usage);
  EXPECT_THAT(err_.str(), testing::StartsWith("mesopix: simulte: unknown command; must be generate, "));
  EXPECT_THAT(err_.str(), testing::EndsWith("; did you mean simulate?\n"));
  expect_refusal({"help", "study", "sumbit"},
                 "sumbit: unknown command; must be submit, status or collect; did you mean submit?");
  expect_refusal({"help", "inspect", "x"}, "x: unknown command; mesopix inspect has no commands below it");
}

}  // namespace help_command_test
