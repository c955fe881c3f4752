#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "specimen/file/specimen_file.hpp"
#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_specimen.hpp"

namespace twin_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::HasSubstr;

/// In a folder that holds a picture of 40 mm with random aggregates.
class TwinCommand : public test::ProgramInFolder {
 protected:
  TwinCommand() : ProgramInFolder("twin") {}
  void SetUp() override {
    ASSERT_EQ(call({"generate", "--width", "40 mm", "--height", "40 mm", "--d-min", "4 mm", "--d-max",
                    "10 mm", "--itz-mode", "none", "-o", "cut.png", "-q"}),
              Exit::ok)
        << err_.str();
  }
};

TEST_F(TwinCommand, MakesSpecimensLikeAPicture) {
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "3", "--json"}), Exit::ok) << err_.str();
  const json found = json::parse(out_.str());
  EXPECT_EQ(found, json::parse(test::read_text("runs/cut-twins/statistics.json")));
  EXPECT_NEAR(found["original"]["aggregate_fraction"].get<double>(), 0.45, 0.01);
  EXPECT_NEAR(found["misfit"]["aggregate_fraction"]["difference"].get<double>(), 0, 0.005);
  EXPECT_THAT(err_.str(), HasSubstr("3 twins of cut, 40 mm x 40 mm, pixels of 0.5 mm, seeds 1 to 3\n"));
  EXPECT_THAT(err_.str(), HasSubstr("wrote runs/cut-twins\n"));
  for (const char* name :
       {"original.h5", "twin_001.h5", "twin_003.h5", "twin_003_preview.png", "report.html"})
    EXPECT_TRUE(fs::exists(fs::path("runs/cut-twins") / name)) << name;
  EXPECT_FALSE(fs::exists("runs/cut-twins/twin_004.h5"));
  EXPECT_EQ(
      call({"simulate", "runs/cut-twins/scene.toml", "--velocity", "1 m/s", "--stop-strain", "2e-5", "-q"}),
      Exit::ok)
      << err_.str();
}

TEST_F(TwinCommand, GivesTheSameFilesForTheSameSeed) {
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "2", "--seed", "7", "-o", "a"}), Exit::ok);
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "1", "--seed", "8", "-o", "b"}), Exit::ok);
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "2", "--seed", "7", "-o", "c"}), Exit::ok);
  EXPECT_EQ(test::read_text("a/twin_001.h5"), test::read_text("c/twin_001.h5"));
  EXPECT_EQ(test::read_text("a/statistics.json"), test::read_text("c/statistics.json"));
  EXPECT_EQ(test::read_text("a/report.html"), test::read_text("c/report.html"));
  EXPECT_EQ(test::read_text("a/twin_002.h5"), test::read_text("b/twin_001.h5"));
  EXPECT_NE(test::read_text("a/twin_001.h5"), test::read_text("b/twin_001.h5"));
}

TEST_F(TwinCommand, TakesSpecimensAndScenesAsWell) {
  ASSERT_EQ(call({"convert", "cut.png", "--width", "40 mm", "--itz-thickness", "1 mm", "-o", "cut.h5", "-q"}),
            Exit::ok);
  ASSERT_EQ(run({"cut.h5", "-n", "1", "-o", "of_file"}), Exit::ok) << err_.str();
  EXPECT_EQ(specimen::read_specimen("of_file/twin_001.h5").itz.thickness, 1e-3);
  test::write_text("scene.toml",
                   "[specimen]\npicture = \"cut.png\"\n[convert]\nwidth = \"40 mm\"\n"
                   "[loading]\ndirection = \"compression\"\n");
  ASSERT_EQ(run({"scene.toml", "-n", "1", "--itz-mode", "none", "-o", "of_scene"}), Exit::ok) << err_.str();
  const specimen::Specimen twin = specimen::read_specimen("of_scene/twin_001.h5");
  EXPECT_EQ(twin.itz.mode, specimen::ItzMode::none);
  EXPECT_THAT(test::read_text("of_scene/scene.toml"), HasSubstr("direction = \"compression\""));
  EXPECT_EQ(specimen::read_specimen("of_file/twin_001.h5").inclusions.front().area,
            twin.inclusions.front().area);
}

TEST_F(TwinCommand, MakesTwinsOfAnotherSizeBorderAndGap) {
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "1", "--twin-width", "60 mm", "--twin-height", "30 mm",
                 "--twin-pixel-size", "1 mm", "--border", "cut", "--gap", "0 mm", "-o", "out", "--json"}),
            Exit::ok)
      << err_.str();
  const specimen::Specimen twin = specimen::read_specimen("out/twin_001.h5");
  EXPECT_EQ(twin.mask.labels.cols, 60);
  EXPECT_EQ(twin.mask.labels.rows, 30);
  const json found = json::parse(out_.str());
  EXPECT_EQ(found["plan"]["gap_m"], 0);
  EXPECT_EQ(found["plan"]["border"], "cut");
  EXPECT_GT(found["twins"][0]["cut_aggregates"], 0);
}

TEST_F(TwinCommand, OverwritesOnlyWhenAskedTo) {
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "3", "-o", "out"}), Exit::ok);
  expect_refusal({"cut.png", "--width", "40 mm", "-n", "1", "-o", "out"}, Exit::usage,
                 "-o: out; is not empty; choose another folder, or add --overwrite");
  ASSERT_EQ(run({"cut.png", "--width", "40 mm", "-n", "1", "-o", "out", "--overwrite"}), Exit::ok);
  EXPECT_TRUE(fs::exists("out/twin_001.h5"));
  EXPECT_FALSE(fs::exists("out/twin_003.h5"));
}

TEST_F(TwinCommand, RefusesWhatItCannotRead) {
  expect_refusal({}, Exit::usage, "PICTURE: missing; mesopix twin PICTURE");
  expect_refusal({"none.png"}, Exit::io,
                 "none.png: No such file or directory; must be a file that can be read");
  expect_refusal({"."}, Exit::usage, "PICTURE: .; is a folder; must be a specimen, a scene or a picture");
  expect_refusal({"cut.png", "--width", "40 mm", "-n", "0"}, Exit::usage,
                 "--count: 0; must lie in [1, 1000]");
  expect_refusal({"cut.png", "--width", "40 mm", "--gap", "-1 mm"}, Exit::usage,
                 "--gap: -1 mm; must be >= 0, or \"auto\"");
  expect_refusal({"cut.png", "--width", "40 mm", "--border", "wall"}, Exit::usage,
                 "--border: wall; must be auto, cut or whole");
  expect_refusal({"cut.png", "--width", "40 mm", "--twin-width", "60.3 mm"}, Exit::data,
                 "twin.width: 60.3 mm; must be a whole number of pixels of 0.5 mm; take 60 mm or 60.5 mm");
  expect_refusal({"cut.png", "--width", "40 mm", "--twin-size", "60 mm"}, Exit::usage,
                 "--twin-size: unknown option; did you mean --twin-width?; mesopix twin --help lists them");
}

TEST_F(TwinCommand, RefusesAnOriginalWithoutAggregates) {
  ASSERT_EQ(call({"generate", "--fraction", "0", "-o", "mortar.h5", "-q"}), Exit::ok);
  expect_refusal(
      {"mortar.h5"}, Exit::data,
      "original: no aggregate; twins need aggregates to match; check how the phases are separated");
  specimen::write_specimen("foreign.h5", test::small_specimen());
  EXPECT_EQ(run({"foreign.h5"}), Exit::data);
  EXPECT_THAT(err_.str(),
              testing::HasSubstr("foreign.h5: has aggregate but tells of no inclusions; twins need their "
                                 "outlines; export its labels as a picture and give that"));
}

}  // namespace twin_command_test
