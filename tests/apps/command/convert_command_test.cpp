#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/program_in_folder.hpp"
#include "tests/apps/small_specimen.hpp"

namespace convert_command_test {

namespace fs = std::filesystem;
using app::Exit;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

/// In a folder with a picture of 100 x 100 pixels: a dark square stone in bright mortar, and strokes on both.
class ConvertCommand : public test::ProgramInFolder {
 protected:
  ConvertCommand() : ProgramInFolder("convert") {}
  void SetUp() override {
    std::string picture = "P5 100 100 255\n", truth = picture;
    for (int r = 0; r < 100; ++r)
      for (int c = 0; c < 100; ++c) {
        const bool is_stone = r >= 30 && r < 70 && c >= 20 && c < 60;
        picture += static_cast<char>((is_stone ? 80 : 170) + (r * 7 + c * 13) % 11);
        truth += static_cast<char>(is_stone ? 1 : 2);
      }
    test::write_text("photo.pgm", picture);
    test::write_text("truth.pgm", truth);
    test::write_text("strokes.csv", strokes_);
  }
  const std::string strokes_ =
      "stroke,phase,width_px,x_px,y_px\n1,aggregate,3,30,40\n1,aggregate,3,50,60\n2,mortar,3,10,10\n"
      "2,mortar,3,90,10\n3,mortar,3,80,90\n";
  std::vector<std::string> command_{"photo.pgm",   "--width",    "20 mm", "--strokes",
                                    "strokes.csv", "--itz-mode", "none"};

  Exit convert(std::vector<std::string> more) {
    std::vector<std::string> all = command_;
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(ConvertCommand, StrokesTeachAndTheReferenceTellsHowWell) {
  ASSERT_EQ(convert({"--reference", "truth.pgm", "--json"}), Exit::ok) << err_.str();
  const json found = json::parse(out_.str());
  EXPECT_GT(found["intersection_over_union"]["aggregate"].get<double>(), 0.9);
  EXPECT_GT(found["boundary_f"]["mortar"].get<double>(), 0.95);
  EXPECT_EQ(found["aggregates_found"]["matched"], 1);
  EXPECT_GT(found["aggregates_found"]["panoptic_quality"].get<double>(), 0.9);
  EXPECT_LT(found["uncertain"].get<double>(), 0.1);
  EXPECT_THAT(found["files"], Contains("photo_overlay.png"));
  ASSERT_EQ(convert({"--reference", "truth.pgm"}), Exit::ok);
  EXPECT_THAT(err_.str(), HasSubstr("boundary F (2 px) "));
  EXPECT_THAT(err_.str(), HasSubstr("1 matched, 0 missed, 0 extra"));
}

TEST_F(ConvertCommand, ModelIsKeptAndSortsAnotherPicture) {
  ASSERT_EQ(convert({"--save-model", "cut.mesomodel", "-o", "a.png", "--json"}), Exit::ok) << err_.str();
  EXPECT_EQ(json::parse(out_.str())["files"], (json{"a.png", "cut.mesomodel"}));
  ASSERT_EQ(
      run({"photo.pgm", "--width", "20 mm", "--model", "cut.mesomodel", "--itz-mode", "none", "-o", "b.png"}),
      Exit::ok)
      << err_.str();
  EXPECT_EQ(test::read_text("a.png"), test::read_text("b.png"));
}

TEST_F(ConvertCommand, SceneRepeatsWhatStrokesTaught) {
  test::write_text(
      "scene.toml",
      "[specimen]\npicture = \"photo.pgm\"\n[convert]\nwidth = \"20 mm\"\nstrokes = \"strokes.csv\"\n"
      "[itz]\nmode = \"none\"\n");
  ASSERT_EQ(convert({"-o", "a.png"}), Exit::ok) << err_.str();
  ASSERT_EQ(run({"scene.toml", "-o", "b.png"}), Exit::ok) << err_.str();
  EXPECT_EQ(test::read_text("a.png"), test::read_text("b.png"));
}

TEST_F(ConvertCommand, MistakesAreRefusedBeforeAnythingIsWritten) {
  expect_refusal({"photo.pgm", "--width", "20 mm", "--save-model", "m.mesomodel"}, Exit::usage,
                 "--save-model: m.mesomodel; needs strokes that teach a model; give --strokes STROKES");
  command_.insert(command_.end(), {"--save-model", "m.h5"});
  expect_refusal(command_, Exit::usage, "--save-model: m.h5; must end in .mesomodel");
  test::write_text("strokes.csv", strokes_ + "4,aggregate,3,10,110\n");
  command_.resize(7);
  expect_refusal(
      command_, Exit::data,
      "strokes.csv: stroke 4: a point at x = 10, y = 110 px; must lie on the picture of 100 x 100 px; "
      "x counts pixels from the left and y from the top");
  EXPECT_FALSE(fs::exists("photo.h5"));
}

TEST_F(ConvertCommand, PageIsRefusedBeforeItBeginsWhereItMakesNoSense) {
  expect_refusal({"photo.pgm", "--port", "8000"},
                 "--port: 8000; is for --edit, which is not given; add --edit");
  expect_refusal({"photo.pgm", "--edit", "--port", "0"}, "--port: 0; must lie in [1, 65535]");
  expect_refusal({"photo.pgm", "--edit", "--model", "m.mesomodel"},
                 "--edit: given with convert.model; a model needs no strokes; leave one of the two out");
  expect_refusal(
      {"photo.pgm", "--edit", "--method", "kmeans"},
      "--edit: given with convert.method = kmeans; strokes belong to method taught; leave one of the "
      "two out");
  expect_refusal({"photo.pgm", "--edit", "-o", "photo.pgm"},
                 "-o: photo.pgm; would overwrite photo.pgm; choose another name");
}

}  // namespace convert_command_test
