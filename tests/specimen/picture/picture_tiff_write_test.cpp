#include <tiffio.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/scratch.hpp"

namespace picture_tiff_write_test {

using specimen::Picture;
using specimen_test::Scratch;

/// What ImageJ 1.53t, OpenCV 4.6, Pillow 9.4 and VTK 9.1 read alike: one page of unsigned bytes or floats, in
/// strips from the top, counted from black, the lowest byte first, without a predictor.
void expect_plain(const std::string& path, int bits, int format) {
  std::ifstream file(path, std::ios::binary);
  char order[2] = {};
  file.read(order, 2);
  EXPECT_EQ(std::string(order, 2), "II");
  TIFF* tiff = TIFFOpen(path.c_str(), "r");
  ASSERT_NE(tiff, nullptr);
  const auto tag = [&](std::uint32_t name) {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(tiff, name, &value);
    return int{value};
  };
  EXPECT_EQ(tag(TIFFTAG_BITSPERSAMPLE), bits);
  EXPECT_EQ(tag(TIFFTAG_SAMPLEFORMAT), format);
  EXPECT_EQ(tag(TIFFTAG_SAMPLESPERPIXEL), 1);
  EXPECT_EQ(tag(TIFFTAG_PHOTOMETRIC), PHOTOMETRIC_MINISBLACK);
  EXPECT_EQ(tag(TIFFTAG_ORIENTATION), ORIENTATION_TOPLEFT);
  EXPECT_EQ(tag(TIFFTAG_FILLORDER), FILLORDER_MSB2LSB);
  EXPECT_EQ(tag(TIFFTAG_COMPRESSION), COMPRESSION_ADOBE_DEFLATE);
  EXPECT_EQ(tag(TIFFTAG_PREDICTOR), PREDICTOR_NONE);
  EXPECT_EQ(TIFFIsTiled(tiff), 0);
  EXPECT_EQ(TIFFLastDirectory(tiff), 1);
  TIFFClose(tiff);
}

TEST(PictureTiffWrite, WritesWhatOtherProgramsReadAlike) {
  const Scratch scratch;
  specimen::LabelledMask mask;
  mask.pixel_size = 0.125e-3;
  mask.labels = {2, 3};
  mask.labels.data = {1, 2, 3, 0, 1, 255};
  specimen::write_labels(scratch.file("labels.tif"), mask);
  expect_plain(scratch.file("labels.tif"), 8, SAMPLEFORMAT_UINT);
  specimen::write_imagej_tiff(scratch.file("imagej.tif"), mask);
  expect_plain(scratch.file("imagej.tif"), 8, SAMPLEFORMAT_UINT);
  const specimen::Raster<float> strain(2, 3);
  specimen::write_imagej_tiff(scratch.file("strain.tif"), strain, mask.pixel_size);
  expect_plain(scratch.file("strain.tif"), 32, SAMPLEFORMAT_IEEEFP);
}

TEST(PictureTiffWrite, WritesScaleAndShadesForImageJ) {
  const Scratch scratch;
  specimen::Raster<std::uint8_t> values(2, 3);
  values.data = {0, 1, 2, 3, 0, 200};
  specimen::write_imagej_tiff(scratch.file("a.tif"), values, 0.125e-3);
  TIFF* tiff = TIFFOpen(scratch.file("a.tif").c_str(), "r");
  ASSERT_NE(tiff, nullptr);
  const char* description = nullptr;
  float resolution = 0;
  std::uint16_t unit = 0;
  TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &description);
  TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &resolution);
  TIFFGetField(tiff, TIFFTAG_RESOLUTIONUNIT, &unit);
  EXPECT_STREQ(description, "ImageJ=1.53t\nunit=mm\nmin=0.0\nmax=200.0\n");
  EXPECT_EQ(resolution, 8);
  EXPECT_EQ(unit, RESUNIT_NONE);
  TIFFClose(tiff);
  const Picture picture = specimen::read_picture(scratch.file("a.tif"));
  EXPECT_TRUE(std::equal(values.data.begin(), values.data.end(), picture.gray.data.begin()));
  EXPECT_DOUBLE_EQ(picture.pixel_size, 0.125e-3);
}

TEST(PictureTiffWrite, WritesFloatsForImageJAsTheyAre) {
  const Scratch scratch;
  specimen::Raster<float> values(2, 2);
  values.data = {1.25e-4F, -3, std::numeric_limits<float>::quiet_NaN(), 0};
  specimen::write_imagej_tiff(scratch.file("a.tif"), values, 0.125e-3);
  TIFF* tiff = TIFFOpen(scratch.file("a.tif").c_str(), "r");
  ASSERT_NE(tiff, nullptr);
  std::array<float, 2> top{}, bottom{};
  EXPECT_EQ(TIFFReadScanline(tiff, top.data(), 0), 1);
  EXPECT_EQ(TIFFReadScanline(tiff, bottom.data(), 1), 1);
  TIFFClose(tiff);
  EXPECT_EQ(top, (std::array{1.25e-4F, -3.0F}));
  EXPECT_TRUE(std::isnan(bottom[0]));
  EXPECT_EQ(bottom[1], 0);
}

}  // namespace picture_tiff_write_test
