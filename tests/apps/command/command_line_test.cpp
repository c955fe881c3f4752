#include "apps/command/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace command_line_test {

using app::Value;
using testing::HasSubstr;

/// Parse arguments as a subcommand that offers loading and phases, and understands generate, would.
struct Parsed {
  explicit Parsed(const std::vector<std::string>& arguments)
      : settings(command, {{"loading", "damage", "phases", "itz"}, {"generate"}, {"damage.seed"}}) {
    command.formatter(app::help_formatter());
    command.allow_extras();
    std::vector<std::string> rest = settings.take_phase_options(arguments);
    std::reverse(rest.begin(), rest.end());
    command.parse(rest);
    app::refuse_remaining(command);
    given = settings.assignments();
  }
  app::Options command{"test"};
  app::SettingOptions settings;
  std::vector<app::Assignment> given;
};

std::string complaint_about(const std::vector<std::string>& arguments) {
  try {
    const Parsed parsed(arguments);
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    return rejected.what();
  }
}

void expect_one(const std::vector<std::string>& arguments, const std::string& key, const Value& value,
                const std::string& field) {
  const Parsed parsed(arguments);
  ASSERT_EQ(parsed.given.size(), 1u);
  EXPECT_EQ(parsed.given[0].key, key);
  EXPECT_EQ(parsed.given[0].value, value);
  EXPECT_EQ(parsed.given[0].field, field);
}

Value text(const std::string& words) { return {words}; }

TEST(SettingOptions, EveryNameOfASettingMeansTheSame) {
  for (const char* name :
       {"--stop-strain", "--stop_strain", "--loading.stop_strain", "--loading.stop-strain"}) {
    expect_one({name, "1e-3"}, "loading.stop_strain", text("1e-3"), "--stop-strain");
    expect_one({std::string(name) + "=1e-3"}, "loading.stop_strain", text("1e-3"), "--stop-strain");
  }
  expect_one({"--set", "loading.stop_strain=1e-3"}, "loading.stop_strain", text("1e-3"),
             "--set loading.stop_strain");
}

TEST(SettingOptions, AnEmptyCommandLineGivesNothing) { EXPECT_TRUE(Parsed({}).given.empty()); }

TEST(SettingOptions, ValuesMayBeginWithADash) {
  expect_one({"--velocity", "-1 m/s"}, "loading.velocity", text("-1 m/s"), "--velocity");
}

TEST(SettingOptions, SwitchesNeedNoValueAndTakeOneBehindAnEqualsSign) {
  expect_one({"--generate.walraven"}, "generate.walraven", {true}, "--generate.walraven");
  expect_one({"--generate.walraven=false"}, "generate.walraven", {false}, "--generate.walraven");
}

TEST(SettingOptions, PhasesOfAnyNameHaveOptions) {
  expect_one({"--mortar.tensile-scale", "12 MPa"}, "phases.mortar.tensile_scale", text("12 MPa"),
             "--mortar.tensile-scale");
  expect_one({"--steel-fibre.young=200 GPa"}, "phases.steel-fibre.young", text("200 GPa"),
             "--steel-fibre.young");
  expect_one({"--phases.mortar.young", "-1 GPa"}, "phases.mortar.young", text("-1 GPa"),
             "--phases.mortar.young");
}

TEST(SettingOptions, GroupsWithAPrefixKeepIt) {
  expect_one({"--itz-mode", "none"}, "itz.mode", text("none"), "--itz-mode");
}

TEST(SettingOptions, OtherGroupsAreUnderstoodByTheirKeys) {
  expect_one({"--generate.fraction", "0.4"}, "generate.fraction", text("0.4"), "--generate.fraction");
  EXPECT_THAT(complaint_about({"--fraction", "0.4"}), HasSubstr("--fraction: unknown option"));
}

TEST(SettingOptions, RefuseWhatIsNotOffered) {
  EXPECT_THAT(complaint_about({"--seed", "3"}), HasSubstr("--seed: unknown option"));
  EXPECT_THAT(complaint_about({"--convert.width", "3 mm"}), HasSubstr("--convert.width: unknown option"));
  EXPECT_EQ(complaint_about({"--set", "damage.seed=3"}), "--set damage.seed: has no effect here; remove it");
}

TEST(SettingOptions, RefuseASettingGivenTwice) {
  EXPECT_EQ(complaint_about({"--velocity", "1 m/s", "--loading.velocity", "2 m/s"}),
            "--velocity: 2 m/s; is given twice; give it once");
  EXPECT_EQ(complaint_about({"--velocity", "1 m/s", "--set", "loading.velocity=2 m/s"}),
            "--set loading.velocity: 2 m/s; is given twice; give it once");
}

TEST(SettingOptions, RefuseASetThatSetsNothing) {
  EXPECT_EQ(complaint_about({"--set", "velocity"}),
            "--set: velocity; must be KEY=VALUE; write e.g. --set \"loading.velocity=0.1 m/s\"");
  EXPECT_EQ(complaint_about({"--set", "loading.velocty=1 m/s"}),
            "--set loading.velocty: unknown key; did you mean loading.velocity?");
}

TEST(RefuseRemaining, SuggestsTheOptionThatWasMeant) {
  EXPECT_EQ(complaint_about({"--velocty", "1 m/s"}),
            "--velocty: unknown option; did you mean --velocity?; mesopix test --help lists them");
  EXPECT_EQ(complaint_about({"--mortar.yung=3"}),
            "--mortar.yung: unknown option; did you mean --mortar.young?; mesopix test --help lists them");
  EXPECT_EQ(complaint_about({"stray"}), "stray: one argument too many; mesopix test --help");
}

TEST(Help, ShowsNameTypeHelpAndDefault) {
  const Parsed parsed({});
  const std::string help = parsed.command.help();
  EXPECT_THAT(help, HasSubstr("--velocity VELOCITY                 of the top platen [0.05 m/s]\n"));
  EXPECT_THAT(help, HasSubstr("--itz-mode ring|points|none         ITZ as pixels"));
  EXPECT_THAT(help, HasSubstr("--PHASE.young PRESSURE"));
  EXPECT_THAT(help, HasSubstr("\nLoading:\n"));
  EXPECT_THAT(help, testing::Not(HasSubstr("generate.fraction")));
}

}  // namespace command_line_test
