#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/jpeg_recipe.hpp"
#include "tests/specimen/picture_checks.hpp"

namespace picture_jpeg_test {

using specimen::Picture;
using specimen_test::expect_refused;
using specimen_test::FileBytes;
using specimen_test::JpegRecipe;
using specimen_test::make_jpeg;
using specimen_test::Scratch;

JpegRecipe colours() { return {JCS_RGB, {{200, 40, 40}, {40, 200, 40}, {40, 40, 200}, {128, 128, 128}}}; }

void expect_near(specimen::Rgb c, int r, int g, int b) {
  EXPECT_NEAR(c.r, r, 4);
  EXPECT_NEAR(c.g, g, 4);
  EXPECT_NEAR(c.b, b, 4);
}

TEST(PictureJpeg, ReadsColourAndDensity) {
  const Scratch scratch;
  JpegRecipe recipe = colours();
  recipe.density = 2400;
  const Picture picture = specimen::read_picture(scratch.write("a.jpg", make_jpeg(recipe)));
  ASSERT_EQ(picture.rows(), 32);
  expect_near(picture.colour(4, 4), 200, 40, 40);
  expect_near(picture.colour(4, 28), 40, 200, 40);
  expect_near(picture.colour(28, 4), 40, 40, 200);
  EXPECT_DOUBLE_EQ(picture.pixel_size, 0.0254 / 2400);
}

TEST(PictureJpeg, ReadsGrayAndProgressive) {
  const Scratch scratch;
  JpegRecipe recipe{JCS_GRAYSCALE, {{10}, {90}, {170}, {250}}};
  recipe.progressive = true;
  const Picture picture = specimen::read_picture(scratch.write("gray.jpg", make_jpeg(recipe)));
  EXPECT_TRUE(picture.colour.empty());
  EXPECT_NEAR(picture.gray(28, 28), 250, 3);
  EXPECT_EQ(picture.pixel_size, 0);
}

TEST(PictureJpeg, TurnsInkIntoLight) {
  const Scratch scratch;
  // libjpeg marks CMYK as Adobe's, which stores it upside down: 255 = no ink.
  const JpegRecipe recipe{JCS_CMYK,
                          {{255, 255, 255, 255}, {0, 255, 255, 255}, {255, 255, 255, 0}, {255, 0, 0, 255}}};
  const Picture picture = specimen::read_picture(scratch.write("ink.jpg", make_jpeg(recipe)));
  expect_near(picture.colour(4, 4), 255, 255, 255);
  expect_near(picture.colour(4, 28), 0, 255, 255);
  expect_near(picture.colour(28, 4), 0, 0, 0);
  expect_near(picture.colour(28, 28), 255, 0, 0);
}

TEST(PictureJpeg, StandsUprightAsTheCameraSays) {
  const Scratch scratch;
  JpegRecipe recipe = colours();
  // Little-endian EXIF with one entry: orientation 6, the top of the scene is on the right of the picture.
  recipe.app1 = {'E', 'x', 'i',  'f', 0, 0, 'I', 'I', 42, 0, 8, 0, 0, 0,
                 1,   0,   0x12, 1,   3, 0, 1,   0,   0,  0, 6, 0, 0, 0};
  const Picture picture = specimen::read_picture(scratch.write("turned.jpg", make_jpeg(recipe)));
  expect_near(picture.colour(4, 4), 40, 40, 200);  // bottom left came to the top left
  expect_near(picture.colour(4, 28), 200, 40, 40);
}

TEST(PictureJpeg, RefusesAFileThatEndsTooEarly) {
  const Scratch scratch;
  const FileBytes whole = make_jpeg(colours());
  const FileBytes half(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() - 40));
  expect_refused(scratch.write("half.jpg", half), "is a damaged JPEG: ");
}

TEST(PictureJpeg, RefusesAHugeClaimBeforeItAsksForMemory) {
  const Scratch scratch;
  FileBytes bytes = make_jpeg(colours());
  const std::vector<std::uint8_t> frame{0xff, 0xc0, 0, 17, 8};  // then height and width
  const auto at = std::search(bytes.begin(), bytes.end(), frame.begin(), frame.end());
  ASSERT_NE(at, bytes.end());
  const auto claim = [&](int edge) {
    for (const int i : {5, 7}) {
      at[i] = static_cast<std::uint8_t>(edge / 256);
      at[i + 1] = static_cast<std::uint8_t>(edge % 256);
    }
  };
  claim(14000);
  expect_refused(scratch.write("claim.jpg", bytes), "bytes cannot hold 14000 x 14000 pixels");
  claim(65000);
  expect_refused(scratch.write("huge.jpg", bytes), "at most 200000000 pixels are allowed");
}

TEST(PictureJpeg, RefusesBeginningsAndSurvivesDamage) {
  const Scratch scratch;
  JpegRecipe recipe = colours();
  recipe.edge = 8;
  EXPECT_EQ(specimen_test::read_all_beginnings(scratch, make_jpeg(recipe)), 0);
  specimen_test::survive_damage(scratch, make_jpeg(recipe));
  recipe.progressive = true;
  specimen_test::survive_damage(scratch, make_jpeg(recipe));
}

}  // namespace picture_jpeg_test
