#include "apps/drawing/drawing_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace drawing_files_test {

using namespace output;
using output::vector_file;
using output::VectorFormat;
using specimen::Raster;
using specimen::Rgb;
using testing::HasSubstr;
using testing::StartsWith;

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

TEST(PngOfDrawing, StatesItsResolutionInPrint) {
  const Drawing drawing{100, 40, "", {}};
  const std::string png = png_of(drawing, 1, 0, 600);
  EXPECT_EQ(png.substr(37, 4), "pHYs");
  EXPECT_EQ(static_cast<unsigned char>(png.at(43)) << 8 | static_cast<unsigned char>(png.at(44)), 23622);
  EXPECT_EQ(decoded(png), decoded(png_of(drawing, 1))) << "its checksum is right";
  EXPECT_EQ(png_of(drawing, 1).find("pHYs"), std::string::npos);
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

TEST(Svg, WritesEachShape) {
  const Drawing drawing{
      100,
      50,
      "t",
      {Stroke{{{1, 2}, {3.25, 4}}, Ink::first, 2, true}, Dot{{5, 6}, 4, Ink::text},
       Words{{7, 8}, "w", 13, Anchor::end, Ink::muted}, Area{{{9, 8}, {7, 6}, {9, 4}}, {255, 128, 0}}}};
  EXPECT_EQ(
      svg_of(drawing),
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 50\" role=\"img\" aria-label=\"t\">\n"
      "<polyline class=\"stroke-first\" stroke-width=\"2\" stroke-dasharray=\"6 4\" points=\"1.0,2.0 "
      "3.2,4.0\"/>\n"
      "<circle class=\"fill-text\" cx=\"5.0\" cy=\"6.0\" r=\"4\"/>\n"
      "<text class=\"fill-muted\" x=\"7.0\" y=\"8.0\" font-size=\"13\" text-anchor=\"end\">w</text>\n"
      "<polygon points=\"9.0,8.0 7.0,6.0 9.0,4.0\" fill=\"#ff8000\"/>\n"
      "</svg>\n");
}

TEST(Svg, EscapesWords) {
  const std::string svg = svg_of({1, 1, "\"><script>", {Words{{0, 0}, "</text><script>"}}});
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
}

output::Drawing small_drawing() {
  specimen::Raster<specimen::Rgb> picture(2, 2);
  output::Drawing drawing{100, 60, "Title", {}};
  drawing.shapes.push_back(output::Pixels{{0, 0}, 40, 40, picture});
  drawing.shapes.push_back(output::Block{{50, 0}, 10, 10, {255, 0, 0}, true});
  drawing.shapes.push_back(output::Words{{50, 40}, "words"});
  return drawing;
}

TEST(VectorFile, IsOfItsFormatAndSize) {
  const std::string svg = vector_file(small_drawing(), VectorFormat::svg, 10);
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("width=\"90pt\" height=\"60pt\""));  // 3/4 of 100 + 20 by 60 + 20
  const std::string pdf = vector_file(small_drawing(), VectorFormat::pdf, 10);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 90 60 ]"));
}

TEST(VectorFile, DoesNotTellTheTimeOfDay) {
  const std::string pdf = vector_file(small_drawing(), VectorFormat::pdf, 0);
  EXPECT_EQ(pdf, vector_file(small_drawing(), VectorFormat::pdf, 0));
  EXPECT_THAT(pdf, testing::Not(HasSubstr("CreationDate")));
}

}  // namespace drawing_files_test
