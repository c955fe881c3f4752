#include "specimen/picture/picture_codecs.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace picture_codecs_test {

using specimen::read_exif;

std::vector<std::uint8_t> big_endian_block() {
  return {'E', 'x',  'i', 'f', 0, 0,                     //
          'M', 'M',  0,   42,  0, 0, 0, 8,               // directory at 8
          0,   4,                                        // four entries
          1,   0x12, 0,   3,   0, 0, 0, 1, 0, 8, 0, 0,   // orientation 8
          1,   0x1a, 0,   5,   0, 0, 0, 1, 0, 0, 0, 62,  // x resolution at 62
          1,   0x1b, 0,   5,   0, 0, 0, 1, 0, 0, 0, 62,  // y resolution at 62
          1,   0x28, 0,   3,   0, 0, 0, 1, 0, 3, 0, 0,   // centimetres
          0,   0,    0,   0,                             // no further directory
          0,   0,    0,   40,  0, 0, 0, 2};              // 40 / 2
}

TEST(PictureExif, ReadsOrientationAndResolution) {
  const auto tags = read_exif(big_endian_block());
  EXPECT_EQ(tags.orientation, 8);
  EXPECT_DOUBLE_EQ(tags.shape.width, 0.01 / 20);
}

TEST(PictureExif, KeepsTheDefaultsWhereTheBlockIsDamaged) {
  const auto whole = big_endian_block();
  for (std::size_t n = 0; n < whole.size(); ++n) {
    const auto tags = read_exif(std::span(whole).first(n));
    EXPECT_GE(tags.orientation, 1);
    EXPECT_EQ(tags.shape.width, 0) << n;
  }
  auto wrong = whole;
  wrong[10] = 0xff;  // the directory lies far outside
  EXPECT_EQ(read_exif(wrong).orientation, 1);
  wrong = whole;
  wrong[25] = 9;  // no such orientation
  EXPECT_EQ(read_exif(wrong).orientation, 1);
}

TEST(DeepColours, AreGreyWhereTheyAreAlike) {
  specimen::Raster<specimen::DeepRgb> deep(1, 2);
  deep.data = {{1, 1, 1}, {300, 300, 300}};
  specimen::Picture picture;
  specimen::set_deep_colours(picture, deep.rows, deep.cols, [&](std::size_t i) { return deep.data[i]; });
  EXPECT_TRUE(picture.colour.empty());
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{1, 300})) << "labels would be lost in bytes";
}

TEST(DeepColours, BecomeTheBytesThatTheyWere) {
  using specimen::Rgb;
  for (const int unit : {1, 256, 257}) {
    const auto channel = [&](int byte) { return static_cast<std::uint16_t>(byte * unit); };
    specimen::Raster<specimen::DeepRgb> deep(1, 2);
    deep.data = {{channel(1), channel(2), channel(3)}, {channel(255), channel(0), channel(128)}};
    specimen::Picture picture;
    specimen::set_deep_colours(picture, deep.rows, deep.cols, [&](std::size_t i) { return deep.data[i]; });
    EXPECT_EQ(picture.colour.data, (std::vector<Rgb>{{1, 2, 3}, {255, 0, 128}})) << unit;
  }
}

}  // namespace picture_codecs_test
