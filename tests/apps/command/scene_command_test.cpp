#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"

namespace scene_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Scene : public test::ProgramInFolder {
 protected:
  Scene() : ProgramInFolder("scene") {}

  /// The scene that init writes with these options, after it was found right.
  std::string begun(std::vector<std::string> options) {
    options.insert(options.begin(), {"init", "--overwrite"});
    EXPECT_EQ(run(options), Exit::ok) << err_.str();
    EXPECT_THAT(err_.str(), Not(HasSubstr("to do")));
    EXPECT_EQ(run({"check", "scene.toml"}), Exit::ok) << out_.str();
    return test::read_text("scene.toml");
  }
};

TEST_F(Scene, NeedsACommand) {
  expect_refusal({}, Exit::usage,
                 "mesopix scene: needs a command; must be init, check or schema; mesopix scene --help");
  expect_refusal({"chek"}, Exit::usage,
                 "mesopix scene: chek; must be init, check or schema; did you mean check?");
  expect_refusal({"check", "--jsn", "a.toml"}, Exit::usage,
                 "--jsn: unknown option; did you mean --json?; mesopix scene check --help lists them");
}

TEST_F(Scene, InitWritesWhatHoldsAndWhatCouldBeChanged) {
  const std::string scene = begun({});
  EXPECT_EQ(err_.str(), "");
  EXPECT_THAT(scene, StartsWith("# A scene of mesopix "));
  EXPECT_THAT(
      scene,
      HasSubstr("\nwidth = \"50 mm\"                    # of the specimen; length > 0 [\"150 mm\"]\n"));
  EXPECT_THAT(scene, HasSubstr("\n#gap = \"0.5 mm\" "));
  EXPECT_THAT(scene, HasSubstr("; tension, compression or none [\"tension\"]\n"));
  EXPECT_THAT(scene, HasSubstr("\n[phases.itz]\nyoung = \"12 GPa\" "));
  for (const char* unused : {"[convert]", "[motion]", "[handover]", "duration"})
    EXPECT_THAT(scene, Not(HasSubstr(unused)));
}

TEST_F(Scene, InitsCommentsHoldWhatHoldsWithoutThem) {
  const std::string scene = begun({});
  ASSERT_EQ(call({"simulate", "scene.toml", "--print-scene"}), Exit::ok);
  const std::string resolved = out_.str();
  std::string all;
  std::istringstream lines(scene);
  for (std::string line; std::getline(lines, line);)
    all += (line.size() > 1 && line[0] == '#' && line[1] != ' ' ? line.substr(1) : line) + "\n";
  EXPECT_NE(all, scene);
  test::write_text("scene.toml", all);
  ASSERT_EQ(call({"simulate", "scene.toml", "--print-scene"}), Exit::ok) << err_.str();
  EXPECT_EQ(out_.str(), resolved);
}

TEST_F(Scene, WhatInitWritesBreaksAsConcreteDoes) {
  begun({});
  ASSERT_EQ(call({"simulate", "scene.toml", "--json", "-q"}), Exit::ok) << err_.str();
  const json figures = json::parse(out_.str());
  EXPECT_EQ(figures["stop_reason"], "drop");
  EXPECT_NEAR(figures["peak_stress_Pa"].get<double>(), 3e6, 1e6);
}

TEST_F(Scene, InitTakesOtherLoadings) {
  EXPECT_THAT(begun({"--loading", "compression"}), HasSubstr("direction = \"compression\""));
  const std::string flight = begun({"--loading", "none"});
  EXPECT_THAT(flight, HasSubstr("\ninitial_velocity_y = \"-10 m/s\""));
  EXPECT_THAT(flight, HasSubstr("\nbottom = \"smooth_wall\""));
  expect_refusal({"init", "--overwrite", "--loading", "pull"}, Exit::usage,
                 "--loading: pull; must be tension, compression or none");
}

TEST_F(Scene, InitTakesPicturesAndSpecimens) {
  ASSERT_EQ(call({"generate", "--width", "60 mm", "--height", "60 mm", "-o", "cut.png"}), Exit::ok);
  ASSERT_EQ(call({"convert", "cut.png", "-o", "cut.h5"}), Exit::ok) << err_.str();
  fs::create_directory("below");
  const std::string scene = begun({"--picture", "cut.png", "--width", "30 mm"});
  EXPECT_THAT(scene, HasSubstr("\npicture = \"cut.png\""));
  EXPECT_THAT(scene, HasSubstr("\n[convert]\n"));
  EXPECT_THAT(scene, HasSubstr("\nwidth = \"30 mm\""));
  EXPECT_THAT(scene, Not(HasSubstr("[generate]")));
  EXPECT_EQ(run({"init", "below/a.toml", "--specimen", "cut.h5"}), Exit::ok) << err_.str();
  EXPECT_THAT(test::read_text("below/a.toml"), HasSubstr("\nfile = \"../cut.h5\""));
  EXPECT_EQ(run({"check", "below/a.toml"}), Exit::ok) << out_.str();
}

TEST_F(Scene, InitAsksForTheScaleOfAPicture) {
  test::write_text("a.pgm", "P2\n2 2\n2\n1 2\n2 2\n");
  expect_refusal(
      {"init", "--picture", "a.pgm"}, Exit::data,
      "a.pgm: does not tell its scale; measure how wide what it shows is, and give --width \"40 mm\"");
  EXPECT_FALSE(fs::exists("scene.toml"));
}

TEST_F(Scene, InitRefusesWhatDoesNotFit) {
  test::write_text("scene.toml", "mine");
  expect_refusal({"init"}, Exit::usage,
                 "FILE: scene.toml is there already; choose another name, or give --overwrite");
  EXPECT_EQ(test::read_text("scene.toml"), "mine");
  expect_refusal({"init", "a.txt"}, Exit::usage, "FILE: a.txt; must end in .toml");
  expect_refusal({"init", "a.toml", "-o", "b.toml"}, Exit::usage,
                 "--output: given with FILE; give one of the two");
  expect_refusal(
      {"init", "a.toml", "--width", "3 mm"}, Exit::usage,
      "--width: 3 mm; is that of a picture, and none is given; add --picture, or change generate.width in "
      "the scene");
  expect_refusal({"init", "a.toml", "--picture", "nothing.png"}, Exit::io,
                 "nothing.png: No such file or directory; must be a file that can be read");
}

TEST_F(Scene, InitNamesTheSchemaThatItWrites) {
  EXPECT_THAT(begun({"--schema", "s.json"}), StartsWith("#:schema ./s.json\n"));
  EXPECT_EQ(json::parse(test::read_text("s.json"))["type"], "object");
  ASSERT_EQ(run({"init", "b.toml", "--schema", "s.json"}), Exit::ok) << err_.str();  // the same one
  test::write_text("s.json", "mine");
  expect_refusal(
      {"init", "c.toml", "--schema", "s.json"}, Exit::usage,
      "--schema: s.json is there already, and another one; choose another name, or give --overwrite");
}

TEST_F(Scene, CheckTellsOfEveryFile) {
  test::write_text("bad.toml", "[loading]\nvelocity = 3\n");
  ASSERT_EQ(run({"init", "-q"}), Exit::ok);
  EXPECT_THAT(err_.str(), IsEmpty());
  EXPECT_EQ(run({"check", "bad.toml", "scene.toml"}), Exit::data);
  EXPECT_THAT(out_.str(),
              HasSubstr("bad.toml:2:12: loading.velocity: 3; needs a unit; write e.g. \"0.05 m/s\"\n"
                        "scene.toml: a scene: random aggregates, 50 mm x 50 mm"));
  EXPECT_EQ(run({"check", "bad.toml", "nothing.toml"}), Exit::io);
  EXPECT_THAT(out_.str(), HasSubstr("nothing.toml: No such file or directory"));
  EXPECT_EQ(run({"check", "-q", "scene.toml"}), Exit::ok);
  EXPECT_EQ(out_.str(), "");
  EXPECT_EQ(run({"check", "--json", "scene.toml"}), Exit::ok);
  EXPECT_EQ(json::parse(out_.str()), json::array());
  EXPECT_EQ(run({"check", "--json", "bad.toml"}), Exit::data);
  EXPECT_EQ(json::parse(out_.str())[0]["line"], 2);
  expect_refusal({"check"}, Exit::usage, "FILE: missing; mesopix scene check FILE");
}

TEST_F(Scene, SchemaDescribesEveryKey) {
  ASSERT_EQ(run({"schema"}), Exit::ok);
  const json schema = json::parse(out_.str());
  const json& velocity = schema["properties"]["loading"]["properties"]["velocity"];
  EXPECT_EQ(velocity["default"], "0.05 m/s");
  EXPECT_EQ(velocity["description"], "of the top platen; velocity > 0; units m/s and mm/s");
  EXPECT_EQ(schema["properties"]["solver"]["properties"]["cell"]["default"], "auto");
  EXPECT_EQ(schema["properties"]["phases"]["properties"]["itz"]["properties"]["young"]["default"], "12 GPa");
  for (const auto& [name, table] : schema["properties"].items()) {
    const json& keys = table["type"] == "array" && name != "ellipses" ? table["items"] : table;
    EXPECT_EQ(name == "ellipses" || keys["additionalProperties"] == false, true) << name;
  }
}

}  // namespace scene_command_test
