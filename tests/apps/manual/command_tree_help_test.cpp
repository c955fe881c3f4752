#include "apps/manual/command_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/manual/example_commands.hpp"

namespace command_tree_help_test {

using testing::ElementsAre;
using testing::SizeIs;

constexpr const char* footer =
    "What is free is\nscaled:\n"
    "  mortar.young      a key\n"
    "                    of the scene\n"
    "  seeds    N|LIST   number of seeds\n"
    "then\n"
    "  [vary]\n"
    "Example: two  of them\n"
    "  mesopix study a.toml --until-ci \"2 %\"\n"
    "  mesopix study submit a.toml --commands | parallel";

TEST(HelpText, TellsTextListsAndExamplesApart) {
  const manual::HelpText text = manual::help_text(footer);
  ASSERT_THAT(text.notes, SizeIs(4));
  EXPECT_EQ(text.notes[0].text, "What is free is scaled:");
  ASSERT_THAT(text.notes[1].items, SizeIs(2));
  EXPECT_EQ(text.notes[1].items[0].term, "mortar.young");
  EXPECT_EQ(text.notes[1].items[0].text, "a key of the scene");
  EXPECT_EQ(text.notes[1].items[1].text, "N|LIST: number of seeds");
  EXPECT_EQ(text.notes[2].text, "then");
  EXPECT_THAT(text.notes[3].verbatim, ElementsAre("[vary]"));
  ASSERT_THAT(text.examples, SizeIs(2));
  EXPECT_EQ(text.examples[0].text, "Example: two  of them");
  EXPECT_THAT(text.examples[1].verbatim, SizeIs(2));
}

TEST(HelpText, FindsTheCommandsOfItsExamples) {
  EXPECT_THAT(test::example_commands(footer),
              ElementsAre("mesopix study a.toml --until-ci \"2 %\"",
                          "mesopix study submit a.toml --commands | parallel"));
}

TEST(HelpText, CutsACommandAsAShellDoes) {
  EXPECT_THAT(test::shell_words("mesopix study a.toml --until-ci \"2 %\""),
              ElementsAre("mesopix", "study", "a.toml", "--until-ci", "2 %"));
  EXPECT_THAT(test::shell_words("mesopix a --commands | parallel"),
              ElementsAre("mesopix", "a", "--commands"));
  EXPECT_THAT(test::shell_words("mesopix a > b"), ElementsAre("mesopix", "a"));
  EXPECT_THAT(test::shell_words("mesopix a # b"), ElementsAre("mesopix", "a"));
}

}  // namespace command_tree_help_test
