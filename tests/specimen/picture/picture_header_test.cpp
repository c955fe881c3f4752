#include "specimen/picture/picture_header.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "specimen/body/error.hpp"

namespace picture_header_test {

using specimen::format_of;
using specimen::Picture;
using specimen::PictureFormat;
using specimen::Raster;

PictureFormat format(const std::string& first) {
  return format_of(specimen::Bytes(first.begin(), first.end()));
}

TEST(PictureHeader, KnowsFormatsByTheirFirstBytes) {
  EXPECT_EQ(format("\x89PNG\r\n\x1a\n"), PictureFormat::png);
  EXPECT_EQ(format("\xff\xd8\xff\xe0"), PictureFormat::jpeg);
  EXPECT_EQ(format(std::string("II*\0", 4)), PictureFormat::tiff);
  EXPECT_EQ(format(std::string("MM\0+", 4)), PictureFormat::tiff);
  EXPECT_EQ(format("\x89HDF\r\n\x1a\n"), PictureFormat::hdf5);
  EXPECT_EQ(format("BM"), PictureFormat::bmp);
  EXPECT_EQ(format("P5\n"), PictureFormat::pnm);
  EXPECT_EQ(format("P2#"), PictureFormat::pnm);
  EXPECT_EQ(format("P8\n"), PictureFormat::unknown);
  EXPECT_EQ(format("Part of a text"), PictureFormat::unknown);
  EXPECT_EQ(format(""), PictureFormat::unknown);
}

TEST(PictureHeader, HasAPixelSizeForSquarePixelsAlone) {
  EXPECT_DOUBLE_EQ(specimen::pixel_shape_of(2000, 2000).width, 0.5e-3);
  EXPECT_DOUBLE_EQ(specimen::pixel_shape_of(2000, 2010).width, 0.5e-3);
  EXPECT_EQ(specimen::pixel_shape_of(2000, 2010).aspect, 1);
  EXPECT_DOUBLE_EQ(specimen::pixel_shape_of(2000, 1000).width, 0.5e-3);
  EXPECT_DOUBLE_EQ(specimen::pixel_shape_of(2000, 1000).aspect, 2);
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {-3.0, -3.0}, {std::nan(""), 1.0}, {1.0, 11.0}}) {
    EXPECT_EQ(specimen::pixel_shape_of(x, y).width, 0);
    EXPECT_EQ(specimen::pixel_shape_of(x, y).aspect, 1);
  }
}

TEST(PictureHeader, ChecksSizesWithoutOverflow) {
  specimen::PictureSource source{"a.png", 100, 10, nullptr};
  EXPECT_NO_THROW(specimen::check_size(source, 10, 10, 10));
  EXPECT_THROW(specimen::check_size(source, 10, 11, 0), specimen::Error);
  EXPECT_THROW(specimen::check_size(source, 10, 10, 11), specimen::Error);
  EXPECT_THROW(specimen::check_size(source, 0xffffffff, 0xffffffff, 0), specimen::Error);
  EXPECT_THROW(specimen::check_size(source, 0, 5, 0), specimen::Error);
}

TEST(PictureHeader, TurnsEveryOrientationUpright) {
  // The scene is 1 2 3 over 4 5 6; what a camera stores of it, by the orientation it then writes.
  const std::vector<std::vector<double>> stored{{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                                {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {3, 6, 2, 5, 1, 4},
                                                {6, 3, 5, 2, 4, 1}, {4, 1, 5, 2, 6, 3}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    Picture picture;
    picture.gray = orientation < 5 ? Raster<double>(2, 3) : Raster<double>(3, 2);
    picture.gray.data = stored[static_cast<std::size_t>(orientation - 1)];
    const Picture scene = specimen::upright(picture, orientation);
    EXPECT_EQ(scene.rows(), 2) << orientation;
    EXPECT_EQ(scene.gray.data.doubles(), stored.front()) << orientation;
  }
}

}  // namespace picture_header_test
