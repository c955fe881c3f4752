#include <gtest/gtest.h>

#include <limits>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/picture_checks.hpp"

namespace picture_bmp_test {

using specimen::Picture;
using specimen::Rgb;
using specimen_test::expect_refused;
using specimen_test::FileBytes;
using specimen_test::Scratch;

void put(FileBytes& bytes, std::uint32_t value, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

struct BmpRecipe {
  std::int32_t cols = 0, rows = 0;
  int bits = 8;
  std::vector<Rgb> palette;
  FileBytes pixels;  ///< padded rows, bottom row first
  std::uint32_t compression = 0, per_metre = 0;
};

FileBytes make_bmp(const BmpRecipe& recipe) {
  FileBytes bytes{'B', 'M'};
  const auto colours = static_cast<std::uint32_t>(recipe.palette.size());
  put(bytes, static_cast<std::uint32_t>(54 + 4 * colours + recipe.pixels.size()), 4);
  put(bytes, 0, 4);
  put(bytes, 54 + 4 * colours, 4);
  put(bytes, 40, 4);
  put(bytes, static_cast<std::uint32_t>(recipe.cols), 4);
  put(bytes, static_cast<std::uint32_t>(recipe.rows), 4);
  put(bytes, 1, 2);
  put(bytes, static_cast<std::uint32_t>(recipe.bits), 2);
  put(bytes, recipe.compression, 4);
  put(bytes, static_cast<std::uint32_t>(recipe.pixels.size()), 4);
  put(bytes, recipe.per_metre, 4);
  put(bytes, recipe.per_metre, 4);
  put(bytes, colours, 4);
  put(bytes, 0, 4);
  for (const Rgb c : recipe.palette) bytes.insert(bytes.end(), {c.b, c.g, c.r, 0});
  bytes.insert(bytes.end(), recipe.pixels.begin(), recipe.pixels.end());
  return bytes;
}

const std::vector<Rgb> two_colours{{255, 0, 0}, {0, 0, 255}};

TEST(PictureBmp, ReadsPalettesOfOneFourAndEightBits) {
  const Scratch scratch;
  const auto indices = [&](int bits, FileBytes pixels) {
    BmpRecipe recipe{3, 2, bits, two_colours, std::move(pixels), 0, 0};
    return specimen::read_picture(scratch.write("palette.bmp", make_bmp(recipe))).indices.data;
  };
  // The bottom row comes first in the file.
  const std::vector<std::uint8_t> wanted{1, 0, 0, 0, 1, 1};
  EXPECT_EQ(indices(1, {0b01100000, 0, 0, 0, 0b10000000, 0, 0, 0}), wanted);
  EXPECT_EQ(indices(4, {0x01, 0x10, 0, 0, 0x10, 0x00, 0, 0}), wanted);
  EXPECT_EQ(indices(8, {0, 1, 1, 0, 1, 0, 0, 0}), wanted);
}

TEST(PictureBmp, ReadsColourBottomUpAndTopDownAndTheScale) {
  const Scratch scratch;
  BmpRecipe recipe{1, 2, 24, {}, {3, 2, 1, 0, 6, 5, 4, 0}, 0, 2000};
  const Picture up = specimen::read_picture(scratch.write("up.bmp", make_bmp(recipe)));
  EXPECT_EQ(up.colour.data, (std::vector<Rgb>{{4, 5, 6}, {1, 2, 3}}));
  EXPECT_DOUBLE_EQ(up.pixel_size, 0.5e-3);
  recipe.rows = -2;
  const Picture down = specimen::read_picture(scratch.write("down.bmp", make_bmp(recipe)));
  EXPECT_EQ(down.colour.data, (std::vector<Rgb>{{1, 2, 3}, {4, 5, 6}}));
  recipe = {1, 1, 32, {}, {9, 8, 7, 0}, 0, 0};
  const Picture wide = specimen::read_picture(scratch.write("wide.bmp", make_bmp(recipe)));
  EXPECT_EQ(wide.colour(0, 0), (Rgb{7, 8, 9}));
  EXPECT_EQ(wide.pixel_size, 0);
}

TEST(PictureBmp, TakesAGrayPaletteForGray) {
  const Scratch scratch;
  const BmpRecipe recipe{2, 1, 8, {{10, 10, 10}, {90, 90, 90}}, {1, 0, 0, 0}, 0, 0};
  const Picture picture = specimen::read_picture(scratch.write("gray.bmp", make_bmp(recipe)));
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{90, 10}));
  EXPECT_EQ(picture.indices.data, (std::vector<std::uint8_t>{1, 0}));
}

TEST(PictureBmp, RefusesWhatItCannotReadWithTheReason) {
  const Scratch scratch;
  const auto refused = [&](const BmpRecipe& recipe, const std::string& text) {
    expect_refused(scratch.write("bad.bmp", make_bmp(recipe)), text);
  };
  refused({2, 1, 8, two_colours, {7, 0, 0, 0}, 0, 0}, "colour 7 of a palette with 2 colours");
  refused({2, 1, 8, two_colours, {0, 0, 0, 0}, 1, 0}, "is a compressed BMP; save it without compression");
  refused({2, 1, 16, {}, {0, 0, 0, 0}, 0, 0}, "is a BMP of 16 bits per pixel; 1, 4, 8, 24 and 32 are read");
  refused({1000, 1000, 24, {}, {0, 0, 0, 0}, 0, 0}, "is truncated: 58 bytes cannot hold 1000 x 1000 pixels");
  refused({2147483647, 2147483647, 24, {}, {}, 0, 0}, "at most 200000000 pixels are allowed");
  refused({-2, 1, 24, {}, {}, 0, 0}, "holds -2 x 1 pixels");
  refused({2, std::numeric_limits<std::int32_t>::min(), 24, {}, {}, 0, 0}, "2 x 2147483648 pixels");
}

TEST(PictureBmp, RefusesBeginningsAndSurvivesDamage) {
  const Scratch scratch;
  const FileBytes whole = make_bmp({3, 2, 4, two_colours, {0x01, 0x10, 0, 0, 0x10, 0x00, 0, 0}, 0, 0});
  EXPECT_EQ(specimen_test::read_all_beginnings(scratch, whole), 0);
  specimen_test::survive_damage(scratch, whole);
}

}  // namespace picture_bmp_test
