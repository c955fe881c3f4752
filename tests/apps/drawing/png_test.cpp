#include "apps/drawing/drawing_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace png_test {

using namespace output;
using specimen::Raster;
using specimen::Rgb;

/// As the specimen library reads it.
Raster<Rgb> decoded(const std::string& png) {
  const std::string path = testing::TempDir() + "png_test_" + std::to_string(::getpid()) + ".png";
  std::ofstream(path, std::ios::binary) << png;
  const specimen::Picture picture = specimen::read_picture(path);
  std::remove(path.c_str());
  return picture.colour;
}

TEST(PngOfPixels, KeepsEveryPixelInItsPlace) {
  Raster<Rgb> picture(2, 3);
  for (int i = 0; i < 6; ++i)
    picture.data[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(40 * i), 7,
                                                 static_cast<std::uint8_t>(255 - i)};
  EXPECT_EQ(decoded(png_of(picture)), picture);
}

TEST(PngOfDrawing, HasItsScaledSizeOnWhitePaper) {
  const Raster<Rgb> picture = decoded(png_of(Drawing{100, 40, "", {}}, 2.5));
  EXPECT_EQ(picture.cols, 250);
  EXPECT_EQ(picture.rows, 100);
  EXPECT_TRUE(std::all_of(picture.data.begin(), picture.data.end(), [](Rgb pixel) {
    return pixel == Rgb{255, 255, 255};
  }));
}

TEST(PngOfDrawing, DrawsLinesWhereTheyAre) {
  const Drawing drawing{100, 40, "", {Stroke{{{10, 20}, {90, 20}}, Ink::first, 4, false}}};
  const Raster<Rgb> picture = decoded(png_of(drawing, 1));
  EXPECT_EQ(picture(20, 50), on_light_paper(Ink::first));
  EXPECT_EQ(picture(30, 50), (Rgb{255, 255, 255}));
  EXPECT_EQ(picture(20, 95), (Rgb{255, 255, 255}));
}

TEST(PngOfDrawing, LeavesAMarginOfPaper) {
  const Drawing drawing{10, 10, "", {Stroke{{{0, 5}, {10, 5}}, Ink::first, 2, false}}};
  const Raster<Rgb> picture = decoded(png_of(drawing, 2, 3));
  EXPECT_EQ(picture.cols, 32);
  EXPECT_EQ(picture.rows, 32);
  EXPECT_EQ(picture(16, 5), (Rgb{255, 255, 255}));
  EXPECT_EQ(picture(16, 6), on_light_paper(Ink::first));
}

TEST(PngOfDrawing, DrawsNothingBetweenShapes) {
  const Drawing drawing{100, 100, "", {Words{{10, 10}, "x"}, Stroke{{{10, 90}, {90, 90}}}, Dot{{90, 10}, 3}}};
  const Raster<Rgb> picture = decoded(png_of(drawing, 1));
  for (int row = 20; row < 80; ++row)
    for (int col = 0; col < 100; ++col)
      ASSERT_EQ(picture(row, col), (Rgb{255, 255, 255})) << row << ' ' << col;
}

TEST(PngOfDrawing, PutsWordsToTheLeftOfTheirEnd) {
  const Drawing drawing{200, 40, "", {Words{{150, 30}, "MMMMM", 13, Anchor::end, Ink::text}}};
  const Raster<Rgb> picture = decoded(png_of(drawing, 1));
  int left = 200, right = -1;
  for (int row = 0; row < 40; ++row)
    for (int col = 0; col < 200; ++col)
      if (picture(row, col).r < 128) {
        left = std::min(left, col);
        right = std::max(right, col);
      }
  EXPECT_NEAR(right, 149, 3);
  EXPECT_LT(left, 110) << "no words were drawn: is a sans-serif face installed?";
}

TEST(PngOfDrawing, FillsAreas) {
  const Raster<Rgb> picture =
      decoded(png_of(Drawing{10, 10, "", {Area{{{0, 0}, {10, 0}, {0, 10}}, {255, 128, 0}}}}, 1));
  EXPECT_EQ(picture(2, 2), (Rgb{255, 128, 0}));
  EXPECT_EQ(picture(8, 8), (Rgb{255, 255, 255}));
}

}  // namespace png_test
