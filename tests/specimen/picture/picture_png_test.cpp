#include <gtest/gtest.h>
#include <zlib.h>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/picture_checks.hpp"
#include "tests/specimen/png_recipe.hpp"

namespace picture_png_test {

using specimen::Picture;
using specimen::Raster;
using specimen::Rgb;
using specimen_test::expect_refused;
using specimen_test::FileBytes;
using specimen_test::make_png;
using specimen_test::PngRecipe;
using specimen_test::Scratch;

TEST(PicturePng, KeepsGrayValuesOfEveryDepthAsStored) {
  const Scratch scratch;
  const auto read = [&](int bits, std::vector<std::uint8_t> data) {
    PngRecipe recipe{4, 1, bits};
    recipe.data = std::move(data);
    return specimen::read_picture(scratch.write("gray.png", make_png(recipe)));
  };
  EXPECT_EQ(read(1, {0b01010000}).gray.data.doubles(), (std::vector<double>{0, 1, 0, 1}));
  EXPECT_EQ(read(2, {0b00011011}).gray.data.doubles(), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(read(4, {0x0f, 0x7a}).gray.data.doubles(), (std::vector<double>{0, 15, 7, 10}));
  EXPECT_EQ(read(8, {0, 1, 128, 255}).gray.data.doubles(), (std::vector<double>{0, 1, 128, 255}));
  const Picture deep = read(16, {0, 1, 1, 0, 0xff, 0xff, 0x12, 0x34});
  EXPECT_EQ(deep.gray.data.doubles(), (std::vector<double>{1, 256, 65535, 0x1234}));
  EXPECT_EQ(deep.bits, 16);
}

TEST(PicturePng, ReadsInterlacedLikePlain) {
  const Scratch scratch;
  PngRecipe recipe{9, 7};
  for (int i = 0; i < 63; ++i) recipe.data.push_back(static_cast<std::uint8_t>(4 * i));
  const Picture plain = specimen::read_picture(scratch.write("plain.png", make_png(recipe)));
  recipe.interlaced = true;
  const Picture interlaced = specimen::read_picture(scratch.write("adam7.png", make_png(recipe)));
  EXPECT_EQ(plain.gray, interlaced.gray);
  EXPECT_EQ(plain.gray(6, 8), 4 * 62);
}

TEST(PicturePng, KeepsTransparentColourWithItsOpacity) {
  const Scratch scratch;
  PngRecipe recipe{3, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA};
  recipe.data = {200, 100, 0, 255, 200, 100, 0, 0, 0, 0, 0, 128};
  const Picture picture = specimen::read_picture(scratch.write("alpha.png", make_png(recipe)));
  EXPECT_EQ(picture.colour.data, (std::vector<Rgb>{{200, 100, 0}, {200, 100, 0}, {0, 0, 0}}));
  EXPECT_EQ(picture.opacity.data, (std::vector<std::uint8_t>{255, 0, 128}));
}

TEST(PicturePng, TurnsUprightWhatItsExifSays) {
  const Scratch scratch;
  FileBytes bytes = make_png({3, 1, 8, PNG_COLOR_TYPE_GRAY, false, {1, 2, 3}});
  // Orientation 6: row 0 is the right side of the scene.
  FileBytes chunk{0, 0,    0, 26, 'e', 'X', 'I', 'f', 'I', 'I', 42, 0, 8, 0, 0, 0, 1,
                  0, 0x12, 1, 3,  0,   1,   0,   0,   0,   6,   0,  0, 0, 0, 0, 0, 0};
  const auto sum = static_cast<std::uint32_t>(crc32(0, &chunk[4], 30));
  for (const unsigned shift : {24U, 16U, 8U, 0U}) chunk.push_back(static_cast<std::uint8_t>(sum >> shift));
  bytes.insert(bytes.begin() + 33, chunk.begin(), chunk.end());  // behind the signature and IHDR
  const Picture picture = specimen::read_picture(scratch.write("turned.png", bytes));
  EXPECT_EQ(picture.rows(), 3);
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{1, 2, 3}));
}

TEST(PicturePng, KeepsTheOpacityOfGray) {
  const Scratch scratch;
  PngRecipe recipe{2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA};
  recipe.data = {7, 255, 9, 0};
  const Picture picture = specimen::read_picture(scratch.write("ga.png", make_png(recipe)));
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{7, 9}));
  EXPECT_EQ(picture.opacity.data, (std::vector<std::uint8_t>{255, 0}));
}

TEST(PicturePng, BringsDeepColourToEightBits) {
  const Scratch scratch;
  PngRecipe recipe{1, 1, 16, PNG_COLOR_TYPE_RGB};
  recipe.data = {0xff, 0xff, 0x80, 0x00, 0x00, 0x00};
  const Picture picture = specimen::read_picture(scratch.write("rgb16.png", make_png(recipe)));
  EXPECT_EQ(picture.colour(0, 0), (Rgb{255, 128, 0}));
  EXPECT_EQ(picture.bits, 16);
}

TEST(PicturePng, KeepsSmallNumbersInDeepColour) {
  const Scratch scratch;
  PngRecipe recipe{2, 1, 16, PNG_COLOR_TYPE_RGB};
  recipe.data = {0, 1, 0, 1, 0, 1, 0, 2, 0, 2, 0, 2};
  const Picture picture = specimen::read_picture(scratch.write("rgb16.png", make_png(recipe)));
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{1, 2}));
}

PngRecipe palette_recipe() {
  PngRecipe recipe{4, 1, 2, PNG_COLOR_TYPE_PALETTE};
  recipe.palette = {{10, 20, 30}, {200, 0, 0}, {0, 0, 0}};
  recipe.data = {0b00011000};
  return recipe;
}

TEST(PicturePng, KeepsThePaletteIndicesBesideTheColours) {
  const Scratch scratch;
  PngRecipe recipe = palette_recipe();
  recipe.opacity = {255, 0};
  const Picture picture = specimen::read_picture(scratch.write("palette.png", make_png(recipe)));
  EXPECT_EQ(picture.indices.data, (std::vector<std::uint8_t>{0, 1, 2, 0}));
  EXPECT_EQ(picture.colour.data, (std::vector<Rgb>{{10, 20, 30}, {200, 0, 0}, {0, 0, 0}, {10, 20, 30}}));
  EXPECT_EQ(picture.opacity.data, (std::vector<std::uint8_t>{255, 0, 255, 255}));
  EXPECT_TRUE(picture.gray.empty());
}

TEST(PicturePng, RefusesAnIndexOutsideThePalette) {
  const Scratch scratch;
  PngRecipe recipe = palette_recipe();
  recipe.data = {0b00110000};
  expect_refused(scratch.write("index.png", make_png(recipe)),
                 "pixel in row 0, column 1 has colour 3 of a palette with 3 colours");
}

TEST(PicturePng, RefusesAnAnimation) {
  const Scratch scratch;
  const FileBytes still = make_png({2, 1, 8, PNG_COLOR_TYPE_GRAY, false, {7, 9}});
  const auto with_pictures = [&](std::uint8_t count) {
    FileBytes chunk{0, 0, 0, 8, 'a', 'c', 'T', 'L', 0, 0, 0, count, 0, 0, 0, 0};
    const auto sum = static_cast<std::uint32_t>(crc32(0, &chunk[4], 12));
    for (const unsigned shift : {24U, 16U, 8U, 0U}) chunk.push_back(static_cast<std::uint8_t>(sum >> shift));
    FileBytes bytes = still;
    bytes.insert(bytes.begin() + 33, chunk.begin(), chunk.end());  // behind the signature and IHDR
    return scratch.write("moves.png", bytes);
  };
  EXPECT_EQ(specimen::read_picture(with_pictures(1)).gray(0, 1), 9);
  expect_refused(with_pictures(2),
                 "is an animated PNG; must hold one picture; save the right one as a separate file");
}

TEST(PicturePng, RefusesAHugeClaimBeforeItAsksForMemory) {
  const Scratch scratch;
  FileBytes bytes = make_png({1, 1, 8, PNG_COLOR_TYPE_GRAY, false, {0}, {}, {}});
  // Width and height stand at 16 to 23, the checksum of the header at 29 to 32.
  for (const std::size_t i : {16U, 20U}) bytes[i] = 0x7f;
  const auto seal = [&] {
    std::uint32_t crc = 0xffffffff;
    for (std::size_t i = 12; i < 29; ++i) {
      crc ^= bytes[i];
      for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<std::uint8_t>(~crc >> (24 - 8 * i));
  };
  seal();
  expect_refused(scratch.write("huge.png", bytes), "at most 200000000 pixels are allowed");
  for (const std::size_t i : {16U, 17U, 20U, 21U}) bytes[i] = 0;
  bytes[18] = bytes[22] = 0x27;  // 9,985 x 9,985 pixels in 67 bytes
  seal();
  expect_refused(scratch.write("empty.png", bytes), "is truncated: 67 bytes cannot hold 9985 x 9985 pixels");
}

TEST(PicturePng, RefusesEveryBeginningAndSurvivesDamage) {
  const Scratch scratch;
  PngRecipe recipe = palette_recipe();
  recipe.interlaced = true;
  const FileBytes whole = make_png(recipe);
  EXPECT_EQ(specimen_test::read_all_beginnings(scratch, whole), 0);
  specimen_test::survive_damage(scratch, whole);
}

TEST(PicturePng, WritesColourAndScaleSoThatTheyComeBack) {
  const Scratch scratch;
  Raster<Rgb> colour(2, 3);
  for (int i = 0; i < 6; ++i)
    colour.data[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(40 * i), 7,
                                                static_cast<std::uint8_t>(255 - i)};
  specimen::write_png(scratch.file("colour.png"), colour, 0.5e-3);
  const Picture picture = specimen::read_picture(scratch.file("colour.png"));
  EXPECT_EQ(picture.colour, colour);
  EXPECT_DOUBLE_EQ(picture.pixel_size, 0.5e-3);  // 2000 pixels per metre exactly
  specimen::write_png(scratch.file("none.png"), colour);
  EXPECT_EQ(specimen::read_picture(scratch.file("none.png")).pixel_size, 0);
}

TEST(PicturePng, RefusesToWriteAPictureOfNothing) {
  const Scratch scratch;
  EXPECT_THROW(specimen::write_png(scratch.file("none.png"), {}), specimen::Error);
  EXPECT_EQ(scratch.files(), 0U);
}

}  // namespace picture_png_test
