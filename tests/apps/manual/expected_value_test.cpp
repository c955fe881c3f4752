#include "apps/manual/expected_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/manual/program_tree.hpp"

namespace expected_value_test {

using manual::expected;
using manual::Option;
using test::command_named;
using test::option_named;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

TEST(ExpectedValue, IsOneOfTheWordsOfTheType) {
  EXPECT_THAT(expected(option_named(command_named("simulate"), "--platen")).words,
              ElementsAre("smooth", "rough"));
  EXPECT_THAT(expected(option_named(command_named("twin"), "--gap")).words, ElementsAre("auto"));
  EXPECT_THAT(expected(option_named(command_named("generate"), "--grading")).words,
              IsSupersetOf({"fuller", "A16"}));
  EXPECT_THAT(expected(option_named(command_named("plot"), "--what")).words,
              ElementsAre("damage", "stress", "curve"));
  const manual::ExpectedValue velocity = expected(option_named(command_named("simulate"), "--velocity"));
  EXPECT_THAT(velocity.words, IsEmpty());
  EXPECT_FALSE(velocity.files || velocity.folders || velocity.keys);
}

TEST(ExpectedValue, IsAFileOrAFolder) {
  EXPECT_TRUE(expected(option_named(command_named("simulate"), "--output")).folders);
  const manual::ExpectedValue picture =
      expected(option_named(command_named("simulate"), "--specimen.picture"));
  EXPECT_TRUE(picture.files);
  EXPECT_THAT(picture.endings, IsSupersetOf({"png", "jpg", "tif"}));
  EXPECT_THAT(expected(option_named(command_named("calibrate"), "--target")).endings, ElementsAre("csv"));
}

TEST(ExpectedValue, OfAnArgumentIsWhatItsHelpSays) {
  EXPECT_THAT(expected(command_named("calibrate").arguments[0]).endings, ElementsAre("toml"));
  const manual::ExpectedValue input = expected(command_named("simulate").arguments[0]);
  EXPECT_THAT(input.endings, IsSupersetOf({"h5", "toml", "png"}));
  EXPECT_FALSE(input.folders);
  EXPECT_TRUE(expected(command_named("report").arguments[0]).folders);
  EXPECT_TRUE(expected(command_named("help").arguments[0]).commands);
  EXPECT_THAT(expected(manual::Argument{"WHAT", "error, stability or features"}).words,
              ElementsAre("error", "stability", "features"));
}

TEST(ExpectedValue, OptionsOfPhasesAreWrittenOut) {
  std::vector<std::string> names;
  for (const Option& option : with_phases(command_named("simulate").options))
    names.insert(names.end(), option.names.begin(), option.names.end());
  EXPECT_THAT(names,
              IsSupersetOf({"--mortar.young", "--itz.tensile-scale", "--aggregate.density", "--velocity"}));
  EXPECT_THAT(names, Not(Contains("--PHASE.young")));
}

TEST(ExpectedValue, KeysAreThoseThatTheCommandTakes) {
  EXPECT_THAT(keys_of(command_named("simulate")),
              IsSupersetOf({"loading.velocity", "generate.width", "phases.mortar.tensile_scale"}));
  EXPECT_THAT(keys_of(command_named("generate")), Not(Contains("loading.velocity")));
  EXPECT_THAT(keys_of(command_named("generate")), Not(Contains("specimen.file")));
  EXPECT_THAT(keys_of(command_named("inspect")), IsEmpty());
  EXPECT_EQ(option_by_key(command_named("convert")), "--itz.segments");
}

TEST(ExpectedValue, NamesByKeyHaveADot) {
  const Option& platen = option_named(command_named("simulate"), "--platen");
  EXPECT_THAT(listed_names(platen), ElementsAre("--platen"));
  EXPECT_THAT(names_by_key(platen), ElementsAre("--loading.platen"));
  EXPECT_THAT(listed_names(option_named(command_named("simulate"), "--generate.width")), IsEmpty());
}

}  // namespace expected_value_test
