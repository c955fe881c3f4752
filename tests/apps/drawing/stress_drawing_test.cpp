#include "apps/drawing/stress_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/drawn.hpp"
#include "tests/apps/fake_run.hpp"

namespace stress_drawing_test {

using namespace output;
using output::phrase_of;
using output::stress_of;
using specimen::Rgb;
using test::drawn;
using test::says;
using Component = output::StressComponent;

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

TEST(StressComponent, GivesBackTheComponents) {
  const mpm::FramePoint point{.sxx = 1, .syy = -2, .szz = 9, .sxy = 3};
  EXPECT_EQ(stress_of(point, Component::xx), 1);
  EXPECT_EQ(stress_of(point, Component::yy), -2);
  EXPECT_EQ(stress_of(point, Component::xy), 3);
}

TEST(StressComponent, PrincipalStressesDoNotTurnWithTheAxes) {
  for (const double angle : {0.0, 0.3, 1.1, 2.0}) {  // 7 and -4 along axes turned by it
    const double c = std::cos(angle), s = std::sin(angle);
    const mpm::FramePoint point{
        .sxx = 7 * c * c - 4 * s * s, .syy = 7 * s * s - 4 * c * c, .szz = 0.6, .sxy = 11 * s * c};
    EXPECT_NEAR(stress_of(point, Component::first), 7, 1e-12);
    EXPECT_NEAR(stress_of(point, Component::third), -4, 1e-12);
    EXPECT_NEAR(stress_of(point, Component::mises), std::sqrt((11 * 11 + 4.6 * 4.6 + 6.4 * 6.4) / 2), 1e-12);
  }
}

TEST(StressComponent, TheOneOutOfThePlaneIsAPrincipalStressToo) {
  EXPECT_EQ(stress_of({.sxx = -5, .syy = -6}, Component::first), 0) << "plane stress";
  EXPECT_EQ(stress_of({.sxx = 5, .syy = 6}, Component::third), 0);
}

/// Uniaxial: the stress; pure shear: sqrt(3) times it; the same on all sides: none.
TEST(StressComponent, VonMisesIsTheStressOfATensionTest) {
  EXPECT_DOUBLE_EQ(stress_of({.syy = -3}, Component::mises), 3);
  EXPECT_DOUBLE_EQ(stress_of({.sxy = 2}, Component::mises), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(stress_of({.sxx = 4, .syy = 4, .szz = 4}, Component::mises), 0);
}

TEST(StressComponent, IsNamedAfterTheLoadingWhereThereIsOne) {
  EXPECT_EQ(phrase_of(Component::yy, true), "stress in the direction of loading");
  EXPECT_EQ(phrase_of(Component::yy, false), "vertical stress");
  EXPECT_EQ(phrase_of(Component::xx, false), "horizontal stress");
  EXPECT_EQ(phrase_of(Component::first, true), "largest principal stress");
}

Drawing bar_of(const ColourBar& bar) {
  Drawing drawing{480, 0, "", {}};
  drawing.height = add_colour_bar(drawing, bar, 20);
  return drawing;
}

/// Middle of the words on the drawing.
double middle_of(const Drawing& drawing, const std::string& text) {
  for (const Words& words : drawn<Words>(drawing))
    if (words.text == text && words.anchor == Anchor::middle) return words.at.x;
  ADD_FAILURE() << text << " is not there";
  return 0;
}

TEST(ColourBar, HasTheColourOfAValueAboveItsNumber) {
  const ColourScale scale{-2, 5};
  const Drawing drawing = bar_of({scale, "stress [MPa]", false, false});
  EXPECT_TRUE(says(drawing, "stress [MPa]"));
  const Pixels bar = drawn<Pixels>(drawing).at(0);
  const std::vector<std::pair<std::string, double>> numbers{{"−2", -2}, {"0", 0}, {"3", 3}, {"5", 5}};
  for (const auto& [text, value] : numbers) {
    const double share = (middle_of(drawing, text) - bar.corner.x) / bar.width;
    EXPECT_NEAR(scale.low + share * (scale.high - scale.low), value, 1e-9);
    const int col = std::min(bar.picture.cols - 1, static_cast<int>(share * bar.picture.cols));
    const specimen::Rgb met = bar.picture(0, col), wanted = scale(value);
    EXPECT_NEAR(met.r, wanted.r, 2);
    EXPECT_NEAR(met.g, wanted.g, 2);
    EXPECT_NEAR(met.b, wanted.b, 2);
  }
}

TEST(ColourBar, HasNumbersAtEndsThatAreRound) {
  for (const double end : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    for (const ColourScale& scale : {ColourScale{-end, end}, ColourScale{0, end}, ColourScale{-end, 0}}) {
      const std::vector<Words> words = drawn<Words>(bar_of({scale, "title", false, false}));
      EXPECT_DOUBLE_EQ(words.at(1).at.x, 16) << scale.low << " " << scale.high;
      EXPECT_DOUBLE_EQ(words.back().at.x, 480 - 16) << scale.low << " " << scale.high;
      EXPECT_LE(words.size(), 12U);
    }
}

TEST(ColourBar, IsPointedWhereThereIsMore) {
  const ColourScale scale{-1, 1};
  EXPECT_TRUE(drawn<Area>(bar_of({scale, "", false, false})).empty());
  const auto below = drawn<Area>(bar_of({scale, "", true, false}));
  ASSERT_EQ(below.size(), 1U);
  EXPECT_EQ(below[0].colour, scale(-1));
  EXPECT_LT(below[0].corners[1].x, below[0].corners[0].x);
  const auto above = drawn<Area>(bar_of({scale, "", false, true}));
  ASSERT_EQ(above.size(), 1U);
  EXPECT_EQ(above[0].colour, scale(1));
  EXPECT_GT(above[0].corners[1].x, above[0].corners[0].x);
  EXPECT_EQ(drawn<Area>(bar_of({scale, "", true, true})).size(), 2U);
}

TEST(ColourBar, StaysOnTheDrawing) {
  const Drawing drawing = bar_of({{-1, 1}, "", true, true});
  for (const Stroke& stroke : drawn<Stroke>(drawing))
    for (const Place& place : stroke.places) {
      EXPECT_GE(place.x, 0);
      EXPECT_LE(place.x, 480);
      EXPECT_LE(place.y, drawing.height);
    }
}

}  // namespace stress_drawing_test
