#include "apps/command/scene_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/specimen/temporary_folder.hpp"

namespace scene_check_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A scene of 20 mm that is made and planned in no time.
constexpr const char* small =
    "[generate]\nwidth = '20 mm'\nheight = '20 mm'\npixel_size = '1 mm'\nd_min = '4 mm'\nd_max = '8 mm'\n"
    "fraction = 0.3\n";

class SceneCheck : public testing::Test {
 protected:
  SceneCheck() { std::filesystem::current_path(folder_ / ""); }
  ~SceneCheck() override { std::filesystem::current_path(before_); }

  static std::vector<std::string> complaints(const std::string& text) {
    test::write_text("a.toml", text);
    std::vector<std::string> lines;
    for (const app::Complaint& one : app::check_file("a.toml").complaints) lines.push_back(app::text(one));
    return lines;
  }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  test::TemporaryFolder folder_;
};

TEST_F(SceneCheck, SaysWhatAGoodSceneIs) {
  test::write_text("a.toml", small);
  const app::CheckedFile checked = app::check_file("a.toml");
  EXPECT_THAT(checked.complaints, IsEmpty());
  EXPECT_THAT(checked.what,
              AllOf(StartsWith("a scene: random aggregates, 20 mm x 20 mm, tension at 0.05 m/s"),
                    HasSubstr("; 400 points, "), HasSubstr(" steps")));
}

TEST_F(SceneCheck, TellsEightMistakesOfAllKindsInOneGo) {
  EXPECT_THAT(
      complaints("[specimen]\nfile = 'nothing.h5'\n"  // 2: no such file
                 "[loading]\nvelocity = 0.1\n"        // 4: no unit
                 "stop_strian = 1e-3\n"               // 5: misspelt
                 "stop_drop = 2\n"                    // 6: too large
                 "ramp_time '1 ms'\n"                 // 7: no TOML
                 "separation = true\n"                // 8: for moving points
                 "[phases.mortar]\npoisson = 0.5\n"   // 10: not in plane strain
                 "[output]\ntitle = 3\n"),            // 12: no text
      ElementsAre(
          StartsWith("a.toml:2:8: specimen.file: nothing.h5: No such file or directory"),
          "a.toml:4:12: loading.velocity: 0.1; needs a unit; write e.g. \"0.05 m/s\"",
          "a.toml:5:1: loading.stop_strian: unknown key; did you mean loading.stop_strain?",
          "a.toml:6:13: loading.stop_drop: 2; must lie in (0, 1), or \"none\"",
          StartsWith("a.toml:7:11: not TOML: "),
          "a.toml:8:14: loading.separation: true; has an effect with solver.kinematics = \"moving\" or "
          "\"auto\" only; remove it",
          "a.toml:10:11: phases.mortar.poisson: 0.5; must lie in [0, 0.4999] in plane strain",
          "a.toml:12:9: output.title: 3; must be a text in quotes"));
}

TEST_F(SceneCheck, TellsWhatPackingAndSolverWouldRefuse) {
  EXPECT_THAT(
      complaints("[generate]\nwidth = '20.3 mm'\nheight = '10.3 mm'\naspect_min = 0.01\n"
                 "[phases.itz]\nfracture_energy = '60 J/m2'\ntensile_scale = 'unbreakable'\n"
                 "[damage]\ncorrelation_length = '1e-15 mm'\n"),
      ElementsAre(StartsWith("a.toml:2:9: generate.width: 20.3 mm; must be a whole number of pixels"),
                  StartsWith("a.toml:3:10: generate.height: 10.3 mm; must be a whole number of pixels"),
                  StartsWith("a.toml:4:14: generate.aspect_min: 0.01; must be between 0.02 and 1"),
                  "a.toml:6:19: phases.itz.fracture_energy: 60 J/m2; needs a tensile_scale"));
}

TEST_F(SceneCheck, TellsWhatOnlyTheSpecimenAndThePlanShow) {
  EXPECT_THAT(complaints(small + std::string("[phases.mortr]\nyoung = '20 GPa'\n")),
              ElementsAre(StartsWith("a.toml:9:9: phases.mortr: no such phase"),
                          StartsWith("a.toml:9:9: phases.mortr.density: 0 kg/m3; must be > 0")));
  EXPECT_THAT(
      complaints(small + std::string("[phases.mortar]\nfracture_energy = '0.001 J/m2'\n")),
      ElementsAre(StartsWith("a.toml:9:19: phases.mortar.fracture_energy: 0.001 J/m2; is less than the "
                             "elastic energy of a crack band")));
  EXPECT_THAT(
      complaints(small + std::string("[loading]\ndirection = 'none'\n[solver]\nkinematics = 'moving'\n")),
      testing::UnorderedElementsAre(HasSubstr("loading.duration: 0 s; must be > 0"),
                                    HasSubstr("loading.initial_velocity_y: 0 m/s; without platens")));
}

TEST_F(SceneCheck, LeavesOutWhatFollowsFromOtherMistakes) {
  EXPECT_THAT(complaints(small + std::string("[solver]\nkinematics = 'movin'\n[motion]\nshape = 'linear'\n")),
              ElementsAre(HasSubstr("did you mean moving?")));
  EXPECT_THAT(complaints(small + std::string("[solver]\nkinematic = 'moving'\n[motion]\nshape = 'linear'\n")),
              ElementsAre(HasSubstr("did you mean solver.kinematics?")));
  EXPECT_THAT(complaints(small + std::string("[solver]\nkinematics 'moving'\n[motion]\nshape = 'linear'\n")),
              ElementsAre(HasSubstr("not TOML")));
  EXPECT_THAT(complaints(small + std::string("[solvr]\nkinematics = 'moving'\n[motion]\nshape = 'linear'\n")),
              ElementsAre(HasSubstr("did you mean solver?")));
  EXPECT_THAT(complaints(small + std::string("[loading]\ninitial_velocity_y = '1 m/s'\n")),
              ElementsAre(HasSubstr("loading.initial_velocity_y: \"1 m/s\"; has an effect with")));
}

TEST_F(SceneCheck, TellsTheRestWhereItIsSoundAllTheSame) {
  EXPECT_THAT(complaints("[generate]\nwidth = '50.3 mm'\nfraction = 0.95\nclasses = ['5 mm .. 10 mm: 100 %'\n"
                         "[loading]\ndirection = 'none'\n[loading]\nvelocity = '1 m/s'\n"
                         "[phases.fibre]\nyoung = '200 GPa'\ndensity '2 g/cm3'\n"),
              ElementsAre(StartsWith("a.toml:2:9: generate.width: 50.3 mm; must be a whole number"),
                          StartsWith("a.toml:3:12: generate.fraction: 95 %; must be between 0 and 90 %"),
                          StartsWith("a.toml:5:1: not TOML"), StartsWith("a.toml:7:1: not TOML"),
                          StartsWith("a.toml:11:9: not TOML")));
  EXPECT_THAT(
      complaints("[generate]\nd_min = '14 mm'\nd_max = '12 mm'\naspect_max = 0.1\n[motion]\nleft = 'opn'\n"),
      ElementsAre(StartsWith("a.toml:3:9: generate.d_max: 12 mm; must be above d_min"),
                  StartsWith("a.toml:4:14: generate.aspect_max: 0.1; must be between aspect_min"),
                  StartsWith("a.toml:6:8: motion.left: \"opn\"; must be closed")));
}

TEST_F(SceneCheck, LooksThroughStudiesWithTheirScene) {
  test::write_text("base.toml", std::string(small) + "[loading]\nvelocity = 3\n");
  EXPECT_THAT(complaints("scene = 'base.toml'\nseeds = 0\n[vary]\n\"loading.velocty\" = ['1 m/s']\n"),
              ElementsAre(StartsWith("a.toml:2:9: seeds: 0; must lie in [1, 100000]"),
                          HasSubstr("did you mean loading.velocity?"),
                          StartsWith("base.toml:9:12: loading.velocity: 3; needs a unit")));
  test::write_text("base.toml", small);
  EXPECT_THAT(complaints("scene = 'base.toml'\nseeds = 2\n[vary]\n\"generate.d_max\" = ['3 mm', '8 mm']\n"),
              ElementsAre(AllOf(HasSubstr("generate.d_max: 3 mm, in member 0"), HasSubstr("above d_min"))));
  test::write_text("a.toml", "scene = 'base.toml'\nseeds = 3\n");
  EXPECT_EQ(app::check_file("a.toml").what, "a study: 3 members of base.toml");
}

TEST_F(SceneCheck, GoesThroughNoRingOfStudies) {
  EXPECT_THAT(complaints("scene = 'a.toml'\nseeds = 2\n"),
              ElementsAre(AllOf(HasSubstr("a.toml"), HasSubstr("is a study itself; must be a scene"))));
  test::write_text("b.toml", "scene = 'c.toml'\nseeds = 2\n");
  test::write_text("c.toml", "scene = 'a.toml'\nseeds = 2\n");
  EXPECT_THAT(complaints("scene = 'b.toml'\nseeds = 2\n"),
              ElementsAre(AllOf(HasSubstr("b.toml"), HasSubstr("is a study itself; must be a scene"))));
}

TEST_F(SceneCheck, EndsAtAHundredMistakesOfAStudyAndItsScene) {
  std::string many = small;
  for (int i = 0; i < 200; ++i) many += "[nothing_" + std::to_string(i) + "]\n";
  test::write_text("base.toml", many);
  EXPECT_EQ(complaints("scene = 'base.toml'\nseeds = 0\nsee = 1\n").size(), app::most_complaints);
}

TEST_F(SceneCheck, TellsFilesThatCannotBeReadFromOthers) {
  EXPECT_FALSE(app::check_file("nothing.toml").readable);
  test::write_text("a.toml", "[specimen]\nfile = 'nothing.h5'\n");
  EXPECT_TRUE(app::check_file("a.toml").readable);
}

TEST_F(SceneCheck, GivesEditorsAList) {
  test::write_text("a.toml", "[loading]\nvelocity = 0.1\nvelocty = 1\n[solver\n");
  const auto list = app::complaints_json({app::check_file("a.toml")});
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(nlohmann::json(list[0]),
            (nlohmann::json{{"file", "a.toml"},
                            {"line", 2},
                            {"column", 12},
                            {"key", "loading.velocity"},
                            {"value", "0.1"},
                            {"problem", "loading.velocity: 0.1; needs a unit; write e.g. \"0.05 m/s\""},
                            {"allowed", "needs a unit"},
                            {"cure", "write e.g. \"0.05 m/s\""}}));
  EXPECT_EQ(list[1]["value"], nullptr);
  EXPECT_EQ(list[1]["cure"], "did you mean loading.velocity?");
  EXPECT_EQ(list[2]["line"], 4);
  EXPECT_EQ(list[1]["allowed"], nullptr);
  EXPECT_EQ(list[2]["key"], nullptr);
  EXPECT_EQ(list[2]["value"], nullptr);
}

}  // namespace scene_check_test
