#include "apps/scene/scene_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/damaged.hpp"

namespace scene_file_test {

using testing::ElementsAre;

/// Every complaint about a scene, one text each; the exit code in front when it is not the one for bad data.
std::vector<std::string> complaints_about(const std::string& toml) {
  try {
    (void)app::resolve(app::parse_scene(toml, "dir/scene.toml"), {});
  } catch (const app::Rejected& rejected) {
    std::vector<std::string> lines;
    for (const app::Complaint& complaint : rejected.complaints) lines.push_back(text(complaint));
    EXPECT_EQ(rejected.code, app::Exit::data);
    return lines;
  }
  return {};
}

app::Settings settings_of(const std::string& toml) {
  return app::resolve(app::parse_scene(toml, "dir/scene.toml"), {}).settings;
}

TEST(SceneFile, AnEmptyOneGivesTheDefaults) {
  const app::Settings settings = settings_of("");
  for (const app::Field& field : app::fields()) EXPECT_EQ(field.get(settings), field.get({})) << field.key;
}

TEST(SceneFile, ChoosesAStopStrainBeyondThePeak) {
  const auto chosen = [](const std::string& loading) {
    return settings_of("[loading]\n" + loading).scene.loading.stop_strain;
  };
  EXPECT_EQ(chosen(""), 4e-4);
  EXPECT_EQ(chosen("stop_drop = 0.2\n"), 1e-3);
  EXPECT_EQ(chosen("direction = \"compression\"\n"), 4e-3);
  EXPECT_EQ(chosen("direction = \"compression\"\nstop_drop = 0.5\n"), 1e-2);
  EXPECT_EQ(chosen("direction = \"compression\"\nstop_strain = 3e-4\n"), 3e-4) << "what is given stays";
}

TEST(SceneFile, SetsWhatItSays) {
  const app::Settings settings = settings_of(R"(
    [loading]
    direction = "compression"
    velocity = "0.2 m/s"
    stop_drop = 0.2
    [phases.mortar]
    young = "25 GPa"
    [phases.fibre]
    young = "200 GPa"
    poisson = 0.3
    density = "7850 kg/m3"
    [generate]
    fraction = "40 %"
    classes = ["5 mm .. 10 mm: 1"]
    [output]
    title = "a title"
  )");
  EXPECT_EQ(settings.scene.loading.direction, mpm::Direction::compression);
  EXPECT_EQ(settings.scene.loading.velocity, 0.2);
  EXPECT_EQ(settings.scene.loading.stop_drop, 0.2);
  ASSERT_EQ(settings.phases.size(), 4u);
  EXPECT_EQ(settings.phases[1].young, 25e9);
  EXPECT_EQ(settings.phases[1].tensile_scale, 15e6);
  EXPECT_EQ(settings.phases[3].name, "fibre");
  EXPECT_FALSE(settings.phases[3].can_fail());
  EXPECT_EQ(settings.packing.fraction, 0.4);
  EXPECT_EQ(settings.grading.classes.size(), 1u);
  EXPECT_EQ(settings.title, "a title");
}

TEST(SceneFile, PathsAreRelativeToIt) {
  EXPECT_EQ(settings_of("specimen.picture = 'a/b.png'").specimen.picture, "dir/a/b.png");
  EXPECT_EQ(settings_of("specimen.file = '../b.h5'").specimen.file, "b.h5");
  EXPECT_EQ(settings_of("specimen.ellipses = '/c.csv'").specimen.ellipses, "/c.csv");
}

TEST(SceneFile, NamesPlaceValueAndCureOfEveryMistakeAtOnce) {
  EXPECT_THAT(
      complaints_about("[solver]\n"
                       "cfl = 2\n"
                       "plane = \"stres\"\n"
                       "[loading]\n"
                       "velocity = 0.05\n"
                       "velocty = \"0.05 m/s\"\n"
                       "stop_strain = nan\n"
                       "[phases.mortar]\n"
                       "young = \"-20 GPa\"\n"
                       "[loadng]\n"
                       "velocity = \"1 m/s\"\n"),
      ElementsAre(
          "dir/scene.toml:2:7: solver.cfl: 2; must lie in (0, 1]",
          "dir/scene.toml:3:9: solver.plane: \"stres\"; must be strain or stress; did you mean stress?",
          "dir/scene.toml:5:12: loading.velocity: 0.05; needs a unit; write e.g. \"0.05 m/s\"",
          "dir/scene.toml:6:1: loading.velocty: unknown key; did you mean loading.velocity?",
          "dir/scene.toml:7:15: loading.stop_strain: nan; must be a finite number",
          "dir/scene.toml:9:9: phases.mortar.young: \"-20 GPa\"; must be > 0",
          "dir/scene.toml:10:2: loadng: unknown key; did you mean loading?"));
}

TEST(SceneFile, TellsAStudyFromAScene) {
  EXPECT_THAT(complaints_about("seeds = 3\n[vary]\n"),
              testing::UnorderedElementsAre(
                  "dir/scene.toml:1:1: seeds: unknown key; is of a study, which mesopix study runs",
                  "dir/scene.toml:2:2: vary: unknown key; is of a study, which mesopix study runs"));
}

TEST(SceneFile, RefusesWrongTypes) {
  EXPECT_THAT(complaints_about("loading = 3"),
              ElementsAre("dir/scene.toml:1:1: loading: must be a table; write [loading]"));
  EXPECT_THAT(complaints_about("velocity = \"1 m/s\""),
              ElementsAre("dir/scene.toml:1:1: velocity: unknown key; did you mean loading.velocity?"));
  EXPECT_THAT(complaints_about("[phases]\nmortar = 3"),
              ElementsAre("dir/scene.toml:2:1: phases.mortar: must be a table; write [phases.mortar]"));
  EXPECT_THAT(
      complaints_about("[phases.'a b']\nyoung = '1 GPa'"),
      ElementsAre(
          "dir/scene.toml:1:9: phases.a b: not a name for a phase; must be letters, digits, _ and -"));
  EXPECT_THAT(complaints_about("[loading.velocity]\nx = 1"),
              ElementsAre("dir/scene.toml:1:1: loading.velocity: a table or a date; must be a single value"));
  EXPECT_THAT(complaints_about("[damage]\nseed = 1979-05-27"),
              ElementsAre("dir/scene.toml:2:8: damage.seed: a table or a date; must be a single value"));
  EXPECT_THAT(complaints_about("[damage]\nseed = -1\n[generate]\nwalraven = 1"),
              ElementsAre("dir/scene.toml:2:8: damage.seed: -1; must be >= 0",
                          "dir/scene.toml:4:12: generate.walraven: 1; must be true or false"));
}

TEST(SceneFile, RefusesWhatIsNoToml) {
  const auto complaints = complaints_about("[loading]\nvelocity = \n");
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_THAT(complaints[0], testing::StartsWith("dir/scene.toml:2:12: not TOML: "));
  EXPECT_EQ(complaints[0].find('\n'), std::string::npos);
  EXPECT_THAT(complaints_about("[loading]\n[loading]\n"), ElementsAre(testing::HasSubstr("not TOML")));
}

TEST(SceneFile, RefusesNumbersThatAreNoneAndTextThatIsNone) {
  for (const char* number : {"nan", "inf", "-inf", "1e400", "[nan]"})
    EXPECT_EQ(complaints_about(std::string("[solver]\ncfl = ") + number).size(), 1u) << number;
  EXPECT_THAT(complaints_about("title = \"caf\xE9\"\n"),
              ElementsAre(testing::StartsWith("dir/scene.toml:1:12: not TOML")));
  EXPECT_THAT(complaints_about("a.b\x1b[2J = 1\n"), ElementsAre(testing::Not(testing::HasSubstr("\x1b"))));
}

TEST(SceneFile, RefusesWhatNestsDeeperThanAnyParserGoes) {
  std::string deep = "a";
  for (int i = 0; i < 100'000; ++i) deep += ".a";
  EXPECT_THAT(complaints_about(deep + " = 1"), ElementsAre(testing::HasSubstr("nested too deep")));
  EXPECT_THAT(complaints_about("a = " + std::string(100'000, '[')),
              ElementsAre(testing::HasSubstr("nested too deep")));
}

TEST(SceneFile, GoesNoFurtherWhereNobodyReadsOn) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "key_" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(complaints_about(text).size(), app::most_complaints);
  text.clear();
  for (int i = 0; i < 256; ++i) text += "[phases.p" + std::to_string(i) + "]\n";
  EXPECT_THAT(complaints_about(text),
              ElementsAre("dir/scene.toml:1:1: phases: 256 tables; must be at most 255"));
}

TEST(SceneFile, DamagedIsReadOrRefused) {
  const std::string good =
      "title = \"a\"\n[loading]\nvelocity = \"5 mm/s\"\n[phases.itz]\nyoung = \"2 GPa\"\n[convert]\ncrop = "
      "[1, 2]\n"
      "[[ellipses]]\nx = 1.5e-2\ny = \"2 mm\"\na = '3 mm'\nb = \"1 mm\"\n";
  std::size_t refused = 0;
  test::damage_text(good,
                    [&](const std::string& text) { refused += complaints_about(text).empty() ? 0 : 1; });
  EXPECT_GT(refused, 10 * good.size());
}

TEST(SceneFile, RefusesSettingsWithoutEffect) {
  EXPECT_THAT(
      complaints_about("[specimen]\npicture = 'a.png'\n[generate]\nfraction = 0.4\n"),
      ElementsAre("dir/scene.toml:4:12: generate.fraction: 0.4; has no effect on a picture; remove it"));
}

TEST(SceneFile, RefusesTwoSources) {
  EXPECT_THAT(
      complaints_about("[specimen]\nfile = 'a.h5'\npicture = 'a.png'\n"),
      ElementsAre("dir/scene.toml:3:11: specimen.picture: given beside specimen.file; a specimen has one "
                  "source: file, picture, ellipses, or none of them for random aggregates"));
}

TEST(SceneFile, ReadsEllipses) {
  const auto ellipses = settings_of(
                            "[[ellipses]]\nx='20 mm'\ny='30 mm'\na='10 mm'\nb='8 mm'\nangle='90 deg'\n"
                            "[[ellipses]]\nx='50 mm'\ny='30 mm'\na='5 mm'\nb='5 mm'\n")
                            .specimen.ellipse_list;
  ASSERT_EQ(ellipses.size(), 2u);
  EXPECT_EQ(ellipses[0].x, 20e-3);
  EXPECT_NEAR(ellipses[0].angle, 1.5707963267948966, 1e-15);
  EXPECT_EQ(ellipses[1].angle, 0);
}

TEST(SceneFile, NamesTheEllipseThatIsWrong) {
  EXPECT_THAT(
      complaints_about("[[ellipses]]\nx='20 mm'\ny=3\na='10 mm'\nb='8 mm'\nangel='90 deg'\n"
                       "[[ellipses]]\nx='20 mm'\ny='1 mm'\na='10 mm'\n"
                       "[[ellipses]]\nx='20 mm'\ny='1 mm'\na='10 mm'\nb='11 mm'\n"),
      ElementsAre("dir/scene.toml:3:3: ellipses[1].y: 3; needs a unit; write e.g. \"0.5 mm\"",
                  "dir/scene.toml:6:1: ellipses[1].angel: unknown key; an ellipse has x, y, a, b and angle",
                  "dir/scene.toml:7:1: ellipses[2]: b is missing; an ellipse needs x, y, a and b",
                  "dir/scene.toml:11:1: ellipses[3]: its semi-axes a = 10 mm and b = 11 mm must obey a >= b; "
                  "swap them and add 90 deg to the angle"));
  EXPECT_THAT(
      complaints_about("ellipses = 3"),
      ElementsAre(
          "dir/scene.toml:1:12: ellipses: not a list of tables; write [[ellipses]] and below it x, y, "
          "a, b and angle"));
}

TEST(Resolve, TheCommandLineWins) {
  const auto scene = app::parse_scene("[loading]\nvelocity = '0.1 m/s'\n", "scene.toml");
  const auto given = app::given_as_option("loading.velocity", app::Kind::quantity, "--velocity", "0.2 m/s");
  const app::Resolved resolved = app::resolve(scene, {given});
  EXPECT_EQ(resolved.settings.scene.loading.velocity, 0.2);
  EXPECT_EQ(resolved.origins.at("loading.velocity").field, "--velocity");
}

TEST(Resolve, MistakesOfTheCommandLineAloneAreOnesOfUsage) {
  const auto given = app::given_as_option("loading.velocity", app::Kind::quantity, "--velocity", "fast");
  try {
    (void)app::resolve({}, {given});
    FAIL();
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    EXPECT_STREQ(rejected.what(), "--velocity: fast; must be a velocity, e.g. \"0.05 m/s\"");
  }
}

TEST(Locate, PutsAComplaintOfTheLibrariesWhereTheUserWroteTheValue) {
  const auto resolved = app::resolve(app::parse_scene("[generate]\nfraction = 0.9", "scene.toml"), {});
  EXPECT_EQ(text(app::locate(resolved.origins, app::complaint("generate.fraction", "90 %", "too much"))),
            "scene.toml:2:12: generate.fraction: 90 %; too much");
  EXPECT_EQ(text(app::locate(resolved.origins, app::complaint("generate.gap", "1 mm", "too much"))),
            "generate.gap: 1 mm; too much");
}

}  // namespace scene_file_test
