#include "apps/manual/command_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/manual/program_tree.hpp"

namespace command_tree_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;

TEST(CommandTree, HoldsEveryCommandThoseBelowOthersToo) {
  std::vector<std::string> names;
  for (const manual::Command* command : every_command(test::program_tree()))
    names.push_back(joined(*command, " "));
  EXPECT_EQ(names.front(), "mesopix");
  EXPECT_THAT(names, IsSupersetOf({"mesopix generate", "mesopix study", "mesopix study submit",
                                   "mesopix study status", "mesopix study collect", "mesopix help"}));
}

TEST(CommandTree, KnowsAnOptionAsItsHelpDoes) {
  const manual::Option& platen = test::option_named(test::command_named("simulate"), "--platen");
  EXPECT_THAT(platen.names, ElementsAre("--platen"));
  EXPECT_EQ(platen.by_key, "--loading.platen");
  EXPECT_EQ(type(platen.form), "smooth|rough");
  EXPECT_EQ(platen.group, "Loading");
  const manual::Option& quiet = test::option_named(test::command_named("simulate"), "-q");
  EXPECT_THAT(quiet.names, ElementsAre("-q", "--quiet"));
  EXPECT_EQ(type(quiet.form), "");
  EXPECT_EQ(quiet.help, "say nothing but errors");
}

TEST(CommandTree, LeavesOutWhatTheHelpDoesNotShow) {
  EXPECT_THROW((void)test::option_named(test::command_named("simulate"), "--generate.width"),
               std::invalid_argument);
  EXPECT_EQ(test::option_named(test::command_named("generate"), "--width").by_key, "--generate.width");
}

TEST(CommandTree, KeysAreThoseThatTheCommandTakes) {
  EXPECT_THAT(test::command_named("simulate").keys,
              IsSupersetOf({"loading.velocity=", "generate.width=", "phases.mortar.tensile_scale="}));
  EXPECT_THAT(test::command_named("inspect").keys, testing::IsEmpty());
  EXPECT_EQ(option_by_key(test::command_named("convert")), "--itz.segments");
}

TEST(CommandTree, KnowsArguments) {
  EXPECT_EQ(synopsis(test::command_named("generate")), "mesopix generate [OPTION...] [SCENE]");
  EXPECT_EQ(synopsis(test::command_named("report")), "mesopix report [OPTION...] RUN...");
  EXPECT_EQ(synopsis(test::command_named("study submit")), "mesopix study submit [OPTION...] STUDY");
}

TEST(CommandTree, GroupsStandInTheOrderOfTheHelp) {
  const std::vector<std::string> groups = option_groups(test::command_named("simulate"));
  EXPECT_EQ(groups.front(), "Options");
  EXPECT_THAT(groups, Contains("Loading"));
  EXPECT_THAT(groups, testing::Not(Contains("")));
}

}  // namespace command_tree_test
