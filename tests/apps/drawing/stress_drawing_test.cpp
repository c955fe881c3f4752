#include "apps/drawing/stress_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/drawn.hpp"
#include "tests/apps/fake_run.hpp"

namespace stress_drawing_test {

using namespace output;
using specimen::Rgb;
using test::drawn;
using test::says;

constexpr Rgb black{0, 0, 0};
constexpr Rgb white{255, 255, 255};

/// Of a mask of pixels of 1 mm: every solid pixel's point at its centre, with syy = its id [MPa].
mpm::Frame frame_of(const specimen::LabelledMask& mask) {
  mpm::Frame frame;
  for (std::uint32_t id = 0; id < mask.labels.size(); ++id) {
    if (mask.labels.data[id] == 0) continue;
    const int row = static_cast<int>(id) / mask.labels.cols, col = static_cast<int>(id) % mask.labels.cols;
    const specimen::Point centre = mask.centre(row, col);
    frame.points.push_back(
        {.id = id, .phase = mask.labels.data[id], .x = centre.x, .y = centre.y, .syy = 1e6 * id});
  }
  return frame;
}

/// Colour in the middle of a pixel of the mask, in a picture that shows `cols` of them side by side.
Rgb colour_at(const Drawing& drawing, int row, int col, int cols) {
  const auto picture = drawn<Pixels>(drawing).at(0).picture;
  const int factor = picture.cols / cols;
  return picture(row * factor + factor / 2, col * factor + factor / 2);
}

class StressDrawing : public testing::Test {
 protected:
  specimen::LabelledMask mask_ = still_run({"022", "222", "220"}).specimen.mask;
  mpm::Frame frame_ = frame_of(mask_);
  StressLook look_{.words = "at some strain"};

  [[nodiscard]] Drawing draw() const { return stress_drawing(mask_, frame_, look_); }
};

TEST_F(StressDrawing, GivesEachPixelTheColourOfItsStress) {
  const ColourScale scale{0, 8};
  look_.range = scale;
  const Drawing drawing = draw();
  EXPECT_EQ(colour_at(drawing, 0, 1, 3), scale(1));
  EXPECT_EQ(colour_at(drawing, 2, 0, 3), scale(6));
  EXPECT_EQ(colour_at(drawing, 0, 0, 3), white);
  EXPECT_EQ(colour_at(drawing, 2, 2, 3), white);
  look_.component = StressComponent::xx;  // is zero everywhere
  EXPECT_EQ(colour_at(draw(), 2, 0, 3), scale(0));
}

TEST_F(StressDrawing, ShowsWhatFailedInBlackAndSaysSo) {
  EXPECT_FALSE(says(draw(), "failed"));
  EXPECT_TRUE(says(draw(), "void"));
  frame_.points[0].damage = 1;
  frame_.points[1].damage = 0.99;
  const Drawing drawing = draw();
  EXPECT_EQ(colour_at(drawing, 0, 1, 3), black);
  EXPECT_NE(colour_at(drawing, 0, 2, 3), black);
  EXPECT_TRUE(says(drawing, "failed"));
}

TEST_F(StressDrawing, NamesOnlyWhatIsInIt) {
  mask_ = still_run({"22", "22"}).specimen.mask;
  frame_ = frame_of(mask_);
  EXPECT_FALSE(says(draw(), "void"));
  EXPECT_FALSE(says(draw(), "no material"));
  EXPECT_TRUE(drawn<Block>(draw()).empty());
}

TEST_F(StressDrawing, DrawsPointsThatMovedWhereTheyAre) {
  const ColourScale scale{0, 8};
  look_.range = scale;
  for (mpm::FramePoint& point : frame_.points) point.x += 1e-3;
  EXPECT_EQ(colour_at(draw(), 0, 1, 3), scale(1)) << "small strain";
  look_.moved = true;
  const Drawing drawing = draw();
  EXPECT_EQ(colour_at(drawing, 0, 2, 4), scale(1));
  EXPECT_EQ(colour_at(drawing, 2, 1, 4), scale(6));
  EXPECT_EQ(colour_at(drawing, 2, 0, 4), white);
  EXPECT_TRUE(says(drawing, "no material"));
}

/// Which say nothing of a pixel of their own.
TEST_F(StressDrawing, LeavesOutExtraPoints) {
  const mpm::Frame before = frame_;
  for (const bool moved : {false, true}) {
    look_.moved = moved;
    frame_ = before;
    const Drawing without = draw();
    frame_.points.push_back({.id = 9, .phase = 3, .x = 0.5e-3, .y = 2.5e-3, .syy = 1e12});
    EXPECT_TRUE(drawn<Pixels>(draw()).at(0).picture == drawn<Pixels>(without).at(0).picture);
    EXPECT_TRUE(drawn<Area>(draw()).empty());
  }
}

TEST_F(StressDrawing, SaysHowManyPointsLieBeyondTheColours) {
  const auto words = [this] {
    std::string all;
    for (const Words& w : drawn<Words>(draw())) all += w.text + "\n";
    return all;
  };
  using testing::HasSubstr;
  using testing::Not;
  look_.range = ColourScale{0, 8};
  EXPECT_THAT(words(), Not(HasSubstr("pointed")));
  look_.range = ColourScale{2, 8};  // 1 of the points 1, 2 ... 7 lies below
  EXPECT_THAT(words(), HasSubstr("pointed end: 14.3\u00A0% of the points lie below"));
  look_.range = ColourScale{0, 5};
  EXPECT_THAT(words(), HasSubstr("pointed end: 28.6\u00A0% of the points lie above"));
  look_.range = ColourScale{2, 5};
  EXPECT_THAT(words(), HasSubstr("pointed ends: 14.3\u00A0% of the points lie below, 28.6\u00A0% above"));
  frame_.points.back().damage = 1;  // is black, whatever it carries
  EXPECT_THAT(words(), HasSubstr("16.7\u00A0% of the points lie below, 16.7\u00A0% above"));
}

TEST_F(StressDrawing, SaysWhatItShowsInWhichUnit) {
  EXPECT_TRUE(says(draw(), "stress in the direction of loading [MPa], tension positive"));
  EXPECT_TRUE(says(draw(), "at some strain"));
  look_.component = StressComponent::mises;
  EXPECT_TRUE(says(draw(), "von Mises stress [MPa]"));
}

TEST_F(StressDrawing, TheScaleBarIsAsLongAsItSays) {
  for (const bool moved : {false, true}) {  // which shows a fourth column
    look_.moved = moved;
    for (mpm::FramePoint& point : frame_.points) point.x += moved ? 1e-3 : 0;
    const std::vector<Stroke> strokes = drawn<Stroke>(draw());
    ASSERT_TRUE(says(draw(), moved ? "1 mm" : "0.5 mm"));
    const auto bar =
        std::find_if(strokes.begin(), strokes.end(), [](const Stroke& s) { return s.width == 3; });
    ASSERT_NE(bar, strokes.end());
    EXPECT_NEAR(bar->places[1].x - bar->places[0].x, moved ? 480 / 4.0 : 480 / 6.0, 1e-9);
  }
}

TEST_F(StressDrawing, HoldsAllThatItDraws) {
  frame_.points[0].damage = 1;
  look_.range = ColourScale{2, 5};
  const Drawing drawing = draw();
  for (const Words& words : drawn<Words>(drawing)) EXPECT_LE(words.at.y, drawing.height);
}

TEST_F(StressDrawing, KnowsAFrameWithoutPoints) {
  frame_.points.clear();
  EXPECT_EQ(colour_at(draw(), 1, 1, 3), white);
}

}  // namespace stress_drawing_test
