#include "apps/drawing/picture_parts.hpp"

#include <gtest/gtest.h>

#include "tests/apps/drawn.hpp"

namespace picture_parts_test {

using namespace output;
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

}  // namespace picture_parts_test
