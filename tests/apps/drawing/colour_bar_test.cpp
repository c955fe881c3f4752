#include "apps/drawing/stress_drawing.hpp"

#include <gtest/gtest.h>

#include "tests/apps/drawn.hpp"

namespace colour_bar_test {

using namespace output;
using test::drawn;
using test::says;

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

}  // namespace colour_bar_test
