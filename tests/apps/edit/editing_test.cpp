#include "apps/edit/editing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/scene/input.hpp"
#include "tests/apps/refusal.hpp"
#include "tests/specimen/dressed.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace editing_test {

namespace fs = std::filesystem;
using app::given_as_option;
using app::Kind;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Beginning : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(picture_, std::ios::binary) << "P5 40 30 255\n" + std::string(1200, 'x');
    std::ofstream(folder_ / "s.csv") << "stroke,phase,x_px,y_px\n1,mortar,3,4\n";
  }
  app::EditBeginning begin(std::vector<app::Assignment> given) {
    const app::Settings settings = app::resolve_picture(picture_, given).settings;
    return app::begin_to_edit(settings, given, file_);
  }
  std::string refusal(std::vector<app::Assignment> given) {
    try {
      return test::refusal([&] { (void)begin(given); });
    } catch (const specimen::Error& error) {
      return error.what();
    }
  }
  app::Assignment strokes(const std::string& name) {
    return given_as_option("convert.strokes", Kind::path, "--strokes", (folder_ / name));
  }
  test::TemporaryFolder folder_;
  std::string picture_ = folder_ / "photo.pgm";
  std::string file_ = folder_ / "photo.strokes.csv";
};

TEST(StrokesFile, IsBesideThePicture) {
  EXPECT_EQ(app::strokes_file_for("photo.jpg", "out/cut.h5"), "photo.strokes.csv");
  const test::TemporaryFolder folder;
  const std::string picture = folder / "photo.jpg";
  EXPECT_EQ(app::strokes_file_for(picture, "cut.h5"), (folder / "photo.strokes.csv"));
  EXPECT_EQ(app::strokes_file_for("/no/such/folder/photo.jpg", "out/cut.h5"), "out/photo.strokes.csv");
}

TEST_F(Beginning, IsEmptyOrTheStrokesOfAnEarlierPage) {
  EXPECT_TRUE(begin({}).lines.empty());
  EXPECT_EQ(begin({}).picture.cols(), 40);
  std::ofstream(file_) << "stroke,phase,x_px,y_px\n1,mortar,3,4\n2,void,3,4\n";
  EXPECT_EQ(begin({}).lines.size(), 2U);
}

TEST_F(Beginning, IsTheFileOfStrokesThatIsGiven) {
  const app::EditBeginning beginning = begin({strokes("s.csv")});
  EXPECT_EQ(beginning.lines.size(), 1U);
  EXPECT_TRUE(beginning.given.empty()) << "the page has strokes of its own";
}

TEST_F(Beginning, PaintedStrokesBecomeLines) {
  specimen::Raster<std::uint8_t> painted(30, 40, specimen::no_stroke);
  painted(3, 4) = painted(3, 5) = specimen::phase::mortar;
  const auto png = specimen_test::stroke_layer(painted);
  std::ofstream(folder_ / "s.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  const app::EditBeginning beginning = begin(
      {strokes("s.png"), given_as_option("convert.label_phases", Kind::list, "--label-phases", "4:fibre")});
  ASSERT_EQ(beginning.lines.size(), 1U);
  EXPECT_EQ(beginning.lines[0].points.size(), 2U);
  EXPECT_TRUE(beginning.given.empty()) << "the lines have the names";
}

TEST_F(Beginning, RefusesWhatMakesNoSense) {
  std::ofstream(file_) << "stroke,phase,x_px,y_px\n1,mortar,3,4\n";
  EXPECT_EQ(refusal({strokes("s.csv")}),
            "--strokes: " + (folder_ / "s.csv") + "; " + file_ +
                " has the strokes of an earlier page; leave --strokes out to go on with these, or move that "
                "file away");
  EXPECT_EQ(refusal({strokes("photo.strokes.csv")}), "nothing") << "they are these";
  EXPECT_EQ(refusal({given_as_option("convert.model", Kind::path, "--model", "m.mesomodel")}),
            "--edit: given with convert.model; a model needs no strokes; leave one of the two out");
  EXPECT_EQ(
      refusal({given_as_option("convert.method", Kind::choice, "--method", "otsu")}),
      "--edit: given with convert.method = otsu; strokes belong to method taught; leave one of the two out");
  EXPECT_THAT(refusal({given_as_option("convert.classes", Kind::integer, "--classes", "3")}),
              HasSubstr("convert.classes"));
}

TEST_F(Beginning, StrokesThatAreDamagedAreNotWrittenOver) {
  std::ofstream(file_) << "stroke,phase\n1,mor";
  EXPECT_THAT(refusal({}), StartsWith(file_));
  EXPECT_TRUE(fs::exists(file_));
}

}  // namespace editing_test
