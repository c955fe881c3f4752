#include "apps/drawing/picture_parts.hpp"

#include <gtest/gtest.h>

#include "tests/apps/drawn.hpp"

namespace picture_parts_test {

using namespace output;
using specimen::Raster;
using specimen::Rgb;
using test::drawn;

TEST(CrispFactor, BringsAPictureToTwiceItsWidthOnPaper) {
  EXPECT_EQ(crisp_factor(300, 300), 4);
  EXPECT_EQ(crisp_factor(20, 960), 1);
  EXPECT_EQ(crisp_factor(20, 5000), 1);
}

TEST(CrispFactor, KeepsTallPicturesSmall) {
  EXPECT_EQ(crisp_factor(1000, 1), 8);
  EXPECT_EQ(crisp_factor(20000, 1), 1);
}

TEST(AddPicture, KeepsItsShape) {
  Drawing drawing;
  EXPECT_DOUBLE_EQ(add_picture(drawing, specimen::Raster<specimen::Rgb>(50, 100)), 240);
  EXPECT_DOUBLE_EQ(drawn<Pixels>(drawing).at(0).width, 480);
}

TEST(AddLegend, BeginsALineWhereOneIsFull) {
  Drawing drawing;
  const LegendEntry entry{{}, std::string(20, 'n')};
  EXPECT_DOUBLE_EQ(add_legend(drawing, {entry, entry}, 100), 100);
  EXPECT_DOUBLE_EQ(add_legend(drawing, {entry, entry, entry}, 100), 100 + text_line);
  for (const Words& words : drawn<Words>(drawing)) EXPECT_LT(words.at.x, 480 - 20 * 8);
}

TEST(AddScaleBar, PutsWordsBelowWhereTheyDoNotFitBeside) {
  Drawing drawing;
  EXPECT_DOUBLE_EQ(add_scale_bar(drawing, 480 / 0.15, 100, "118 microstrain, 100 % of the peak strain"), 100);
  EXPECT_EQ(drawn<Words>(drawing).back().anchor, Anchor::end);
  drawing.text = 1.4;
  EXPECT_DOUBLE_EQ(add_scale_bar(drawing, 480 / 0.15, 100, "118 microstrain, 100 % of the peak strain"),
                   100 + 1.4 * text_line);
  EXPECT_EQ(drawn<Words>(drawing).back().anchor, Anchor::start);
  EXPECT_DOUBLE_EQ(drawn<Words>(drawing).back().size, 14 * 1.4);
}

TEST(AddWords, BreaksLinesAtBlanks) {
  Drawing drawing;
  EXPECT_DOUBLE_EQ(add_words(drawing, "short", 10, 14), 10);
  EXPECT_DOUBLE_EQ(add_words(drawing, std::string(40, 'a') + " " + std::string(40, 'b'), 10, 14),
                   10 + 1.4 * 14);
  const std::vector<Words> words = drawn<Words>(drawing);
  ASSERT_EQ(words.size(), 3U);
  EXPECT_EQ(words[1].text, std::string(40, 'a'));
  EXPECT_EQ(words[2].text, std::string(40, 'b'));
}

Raster<Rgb> numbered(int rows, int cols) {
  Raster<Rgb> picture(rows, cols);
  for (std::size_t i = 0; i < picture.size(); ++i) picture.data[i] = {static_cast<std::uint8_t>(i), 100, 200};
  return picture;
}

TEST(Magnified, RepeatsEveryPixel) {
  const Raster<Rgb> small = numbered(2, 3);
  const Raster<Rgb> large = magnified(small, 4);
  ASSERT_EQ(large.rows, 8);
  ASSERT_EQ(large.cols, 12);
  for (int row = 0; row < 8; ++row)
    for (int col = 0; col < 12; ++col) EXPECT_EQ(large(row, col), small(row / 4, col / 4));
}

TEST(Shrunk, UndoesMagnified) {
  const Raster<Rgb> small = numbered(3, 5);
  EXPECT_EQ(shrunk(magnified(small, 3), 3), small);
  EXPECT_EQ(shrunk(small, 1), small);
}

TEST(Shrunk, TakesTheMeanAndWhatIsLeftAtTheEdges) {
  Raster<Rgb> picture(3, 3, {10, 10, 10});
  picture(0, 0) = {50, 10, 10};
  picture(2, 2) = {9, 9, 9};
  const Raster<Rgb> small = shrunk(picture, 2);
  ASSERT_EQ(small.rows, 2);
  ASSERT_EQ(small.cols, 2);
  EXPECT_EQ(small(0, 0), (Rgb{20, 10, 10}));
  EXPECT_EQ(small(1, 1), (Rgb{9, 9, 9}));
}

TEST(FileMagnification, BringsSmallMasksToSixHundredPixels) {
  EXPECT_EQ(file_magnification(150, 150), 4);
  EXPECT_EQ(file_magnification(300, 300), 2);
  EXPECT_EQ(file_magnification(299, 299), 3);
  EXPECT_EQ(file_magnification(600, 600), 1);
  EXPECT_EQ(file_magnification(5000, 5000), 1);
  EXPECT_EQ(file_magnification(2000, 10), 2) << "a narrow strip must not become huge";
}

TEST(ShrinkFactor, BringsTheLongerSideBelowALimit) {
  EXPECT_EQ(shrink_factor(300, 900, 900), 1);
  EXPECT_EQ(shrink_factor(300, 901, 900), 2);
  EXPECT_EQ(shrink_factor(4000, 100, 900), 5);
}

}  // namespace picture_parts_test
