#include <tiffio.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "specimen/picture/picture.hpp"
#include "tests/specimen/picture_checks.hpp"
#include "tests/specimen/tiff_recipe.hpp"

namespace picture_tiff_test {

using specimen::Picture;
using specimen::Rgb;
using specimen_test::expect_refused;
using specimen_test::FileBytes;
using specimen_test::Scratch;
using specimen_test::TiffRecipe;

template <class T>
std::string make_tiff(const Scratch& scratch, const TiffRecipe& recipe, const std::vector<T>& data) {
  const std::string path = scratch.file("recipe.tif");
  specimen_test::write_tiff(path, recipe, data);
  return path;
}

template <class T>
void expect_values(int format, std::vector<T> data) {
  const Scratch scratch;
  TiffRecipe recipe;
  recipe.bits = static_cast<int>(8 * sizeof(T));
  recipe.format = format;
  for (const bool big_endian : {false, true}) {
    recipe.big_endian = big_endian;
    const Picture picture = specimen::read_picture(make_tiff(scratch, recipe, data));
    EXPECT_EQ(picture.gray.data.doubles(), std::vector<double>(data.begin(), data.end()));
    EXPECT_EQ(picture.bits, recipe.bits);
  }
}

TEST(PictureTiff, KeepsNumbersOfEveryKindAsStored) {
  expect_values<std::uint8_t>(SAMPLEFORMAT_UINT, {0, 1, 200, 255});
  expect_values<std::uint16_t>(SAMPLEFORMAT_UINT, {0, 1, 300, 65535});
  expect_values<std::uint32_t>(SAMPLEFORMAT_UINT, {0, 1, 70000, 4294967295U});
  expect_values<std::int8_t>(SAMPLEFORMAT_INT, {-128, -1, 0, 127});
  expect_values<std::int16_t>(SAMPLEFORMAT_INT, {-32768, -1, 0, 32767});
  expect_values<std::int32_t>(SAMPLEFORMAT_INT, {-2147483647, -1, 45, 2147483647});
  expect_values<std::uint64_t>(SAMPLEFORMAT_UINT, {0, 1, 4294967296U, 9007199254740992U});
  expect_values<std::int64_t>(SAMPLEFORMAT_INT, {-9007199254740992, -1, 0, 5000000000});
  expect_values<float>(SAMPLEFORMAT_IEEEFP, {-1.5F, 0.25F, 0, 1e20F});
  expect_values<double>(SAMPLEFORMAT_IEEEFP, {-1.5, 0.1, 0, 1e200});
}

TEST(PictureTiff, ReadsBitsOfOneTwoAndFour) {
  const Scratch scratch;
  TiffRecipe recipe{4, 1, 1};
  const auto read = [&](int bits, std::vector<std::uint8_t> data) {
    recipe.bits = bits;
    return specimen::read_picture(make_tiff(scratch, recipe, std::move(data))).gray.data.doubles();
  };
  EXPECT_EQ(read(1, {0b01010000}), (std::vector<double>{0, 1, 0, 1}));
  EXPECT_EQ(read(2, {0b00011011}), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(read(4, {0x0f, 0x7a}), (std::vector<double>{0, 15, 7, 10}));
  recipe.photometric = PHOTOMETRIC_MINISWHITE;
  EXPECT_EQ(read(2, {0b00011011}), (std::vector<double>{3, 2, 1, 0}));
}

template <class T>
void expect_white_is_zero() {
  const Scratch scratch;
  TiffRecipe recipe{4, 1, static_cast<int>(8 * sizeof(T))};
  recipe.photometric = PHOTOMETRIC_MINISWHITE;
  const double white = std::ldexp(1.0, recipe.bits) - 1;
  const Picture picture = specimen::read_picture(make_tiff<T>(scratch, recipe, {0, 1, 2, 100}));
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{white, white - 1, white - 2, white - 100}))
      << recipe.bits;
}

/// Pillow 9.4 and OpenCV 4.6 do it at 8 bits and not at 16, so that stones and pores change places.
TEST(PictureTiff, CountsFromBlackWhateverTheBitsWhereZeroIsWhite) {
  expect_white_is_zero<std::uint8_t>();
  expect_white_is_zero<std::uint16_t>();
  expect_white_is_zero<std::uint32_t>();
}

TEST(PictureTiff, ReadsTilesAndCompressedStripsLikePlainOnes) {
  const Scratch scratch;
  TiffRecipe recipe{37, 21, 16};
  std::vector<std::uint16_t> data;
  for (int i = 0; i < 37 * 21; ++i) data.push_back(static_cast<std::uint16_t>(i * i));
  const Picture plain = specimen::read_picture(make_tiff(scratch, recipe, data));
  recipe.compression = COMPRESSION_LZW;
  EXPECT_EQ(specimen::read_picture(make_tiff(scratch, recipe, data)).gray, plain.gray);
  recipe.tile = 16;
  EXPECT_EQ(specimen::read_picture(make_tiff(scratch, recipe, data)).gray, plain.gray);
  EXPECT_EQ(plain.gray(20, 36), data.back());
}

TEST(PictureTiff, ReadsColourAndPalettes) {
  const Scratch scratch;
  TiffRecipe recipe;
  recipe.samples = 3;
  recipe.photometric = PHOTOMETRIC_RGB;
  const Picture colour = specimen::read_picture(
      make_tiff<std::uint8_t>(scratch, recipe, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(colour.colour.data, (std::vector<Rgb>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}));
  recipe.samples = 1;
  recipe.photometric = PHOTOMETRIC_PALETTE;
  const Picture palette = specimen::read_picture(make_tiff<std::uint8_t>(scratch, recipe, {0, 1, 2, 255}));
  EXPECT_EQ(palette.indices.data, (std::vector<std::uint8_t>{0, 1, 2, 255}));
  EXPECT_EQ(palette.colour.data, (std::vector<Rgb>{{255, 0, 0}, {254, 0, 0}, {253, 0, 0}, {0, 0, 0}}));
}

TEST(PictureTiff, ReadsDeepColoursAsTheBytesThatTheyWere) {
  const Scratch scratch;
  TiffRecipe recipe{1, 1, 16, SAMPLEFORMAT_UINT, 3, PHOTOMETRIC_RGB};
  for (const int unit : {1, 256, 257}) {
    const auto channel = [&](int byte) { return static_cast<std::uint16_t>(byte * unit); };
    const Picture picture = specimen::read_picture(
        make_tiff<std::uint16_t>(scratch, recipe, {channel(200), channel(100), channel(50)}));
    EXPECT_EQ(picture.colour(0, 0), (Rgb{200, 100, 50})) << unit;
  }
  const Picture labels = specimen::read_picture(make_tiff<std::uint16_t>(scratch, recipe, {3, 3, 3}));
  EXPECT_EQ(labels.gray(0, 0), 3);
}

/// Writes tags into a TIFF of four values a pixel, or fewer.
std::string with_samples(const Scratch& scratch, int samples, int photometric,
                         std::vector<std::uint16_t> extra) {
  TiffRecipe recipe{1, 1, 8, SAMPLEFORMAT_UINT, samples, photometric};
  std::vector<std::uint8_t> data{10, 20, 30, 100, 7};
  data.resize(static_cast<std::size_t>(samples));
  const std::string path = make_tiff<std::uint8_t>(scratch, recipe, data);
  const TIFFErrorHandler warn = TIFFSetWarningHandler(nullptr);  // that it is not told what they are
  TIFF* tiff = TIFFOpen(path.c_str(), "r+");
  if (!extra.empty()) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, static_cast<int>(extra.size()), extra.data());
  TIFFRewriteDirectory(tiff);
  TIFFClose(tiff);
  TIFFSetWarningHandler(warn);
  return path;
}

TEST(PictureTiff, AFourthSampleIsOpacityOnlyIfTheFileSaysSo) {
  const Scratch scratch;
  const Picture infrared =
      specimen::read_picture(with_samples(scratch, 4, PHOTOMETRIC_RGB, {EXTRASAMPLE_UNSPECIFIED}));
  EXPECT_EQ(infrared.colour(0, 0), (Rgb{10, 20, 30}));
  EXPECT_TRUE(infrared.opacity.empty());
  ASSERT_EQ(infrared.notes.size(), 1U);
  EXPECT_EQ(infrared.notes[0],
            "left out the channel beside red, green and blue, which the file does not call opacity");
  const Picture clear =
      specimen::read_picture(with_samples(scratch, 4, PHOTOMETRIC_RGB, {EXTRASAMPLE_UNASSALPHA}));
  EXPECT_EQ(clear.colour(0, 0), (Rgb{10, 20, 30}));
  EXPECT_EQ(clear.opacity(0, 0), 100);
  const Picture multiplied =
      specimen::read_picture(with_samples(scratch, 4, PHOTOMETRIC_RGB, {EXTRASAMPLE_ASSOCALPHA}));
  EXPECT_EQ(multiplied.colour(0, 0), (Rgb{26, 51, 77}));
}

TEST(PictureTiff, RefusesSeveralGreyValuesAPixel) {
  const Scratch scratch;
  for (const int samples : {2, 3, 5})
    expect_refused(
        with_samples(
            scratch, samples, PHOTOMETRIC_MINISBLACK,
            std::vector<std::uint16_t>(static_cast<std::size_t>(samples) - 1, EXTRASAMPLE_UNSPECIFIED)),
        "holds " + std::to_string(samples) + " grey values a pixel; must hold one, or red, green and blue");
  const Picture clear =
      specimen::read_picture(with_samples(scratch, 2, PHOTOMETRIC_MINISBLACK, {EXTRASAMPLE_UNASSALPHA}));
  EXPECT_EQ(clear.gray(0, 0), 10);
  EXPECT_EQ(clear.opacity(0, 0), 20);
}

/// The picture of four pixels with another description, or a depth.
std::string described(const Scratch& scratch, const std::string& description, int depth = 1) {
  const std::string path = make_tiff<std::uint8_t>(scratch, {}, {1, 2, 3, 4});
  TIFF* tiff = TIFFOpen(path.c_str(), "r+");
  if (!description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
  if (depth > 1) TIFFSetField(tiff, TIFFTAG_IMAGEDEPTH, depth);
  TIFFRewriteDirectory(tiff);
  TIFFClose(tiff);
  return path;
}

TEST(PictureTiff, RefusesSlicesBehindOneDirectory) {
  const Scratch scratch;
  expect_refused(described(scratch, "ImageJ=1.53t\nimages=3\nslices=3\n"),
                 "is an ImageJ stack of 3 images; must hold one picture");
  expect_refused(described(scratch, "ImageJ=1.53t\nchannels=2\n"), "is an ImageJ stack of 2 channels");
  expect_refused(described(scratch, "", 3), "is a TIFF of 3 slices; must hold one picture");
  EXPECT_EQ(specimen::read_picture(described(scratch, "ImageJ=1.53t\nimages=1\n")).gray(1, 1), 4);
}

TEST(PictureTiff, TakesItsScaleFromOme) {
  const Scratch scratch;
  const auto with = [&](const std::string& attributes) {
    return specimen::read_picture(
        described(scratch, "<?xml version='1.0'?><OME><Image><Pixels " + attributes + "/></Image></OME>"));
  };
  EXPECT_DOUBLE_EQ(with(R"(PhysicalSizeX="2.5" PhysicalSizeY="2.5")").pixel_size, 2.5e-6);
  EXPECT_DOUBLE_EQ(
      with("PhysicalSizeX='0.1' PhysicalSizeXUnit='mm' PhysicalSizeY='0.1' PhysicalSizeYUnit='mm'")
          .pixel_size,
      1e-4);
  const Picture oblong = with(
      "PhysicalSizeX='7' PhysicalSizeXUnit='\xce\xbcm' PhysicalSizeY='14' PhysicalSizeYUnit='\xc2\xb5m'");
  EXPECT_DOUBLE_EQ(oblong.pixel_size, 7e-6);
  EXPECT_DOUBLE_EQ(oblong.pixel_aspect, 2);
}

TEST(PictureTiff, StandsUpright) {
  const Scratch scratch;
  TiffRecipe recipe{3, 1};
  recipe.orientation = ORIENTATION_LEFTBOT;  // 8: column 0 is the bottom of the scene
  const Picture picture = specimen::read_picture(make_tiff<std::uint8_t>(scratch, recipe, {1, 2, 3}));
  EXPECT_EQ(picture.rows(), 3);
  EXPECT_EQ(picture.gray.data.doubles(), (std::vector<double>{3, 2, 1}));
}

TEST(PictureTiff, KeepsNotANumberAndRefusesInfinity) {
  const Scratch scratch;
  TiffRecipe recipe;
  recipe.bits = 32;
  recipe.format = SAMPLEFORMAT_IEEEFP;
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Picture picture = specimen::read_picture(make_tiff<float>(scratch, recipe, {0, nan, 1, 2}));
  EXPECT_TRUE(std::isnan(picture.gray(0, 1)));
  expect_refused(make_tiff<float>(scratch, recipe, {0, nan, 1, inf}),
                 "holds 1 infinite pixels, the first in row 1, column 1");
}

TEST(PictureTiff, RefusesAHugeClaimBeforeItAsksForMemory) {
  const Scratch scratch;
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW}) {
    TiffRecipe recipe;
    recipe.compression = compression;
    make_tiff<std::uint8_t>(scratch, recipe, {1, 2, 3, 4});
    FileBytes bytes = scratch.read("recipe.tif");
    for (const std::uint8_t tag : {0x00, 0x01}) {  // width and length: 0x100 and 0x101
      std::vector<std::uint8_t> entry{tag, 1, 3, 0, 1, 0, 0, 0, 2, 0, 0, 0};
      const auto at = std::search(bytes.begin(), bytes.end(), entry.begin(), entry.end());
      ASSERT_NE(at, bytes.end());
      at[8] = 0xb0;
      at[9] = 0x36;  // 14,000
    }
    expect_refused(scratch.write("claim.tif", bytes), "bytes cannot hold 14000 x 14000 pixels");
  }
}

/// libtiff would unpack 1 GiB for each of them.
TEST(PictureTiff, RefusesTilesThatAreLargerThanThePicture) {
  const Scratch scratch;
  TiffRecipe recipe{20, 20};
  recipe.tile = 16;
  recipe.compression = COMPRESSION_ADOBE_DEFLATE;
  make_tiff(scratch, recipe, std::vector<std::uint8_t>(400));
  FileBytes bytes = scratch.read("recipe.tif");
  for (const std::uint8_t tag : {0x42, 0x43}) {  // width and length: 0x142 and 0x143
    const std::vector<std::uint8_t> entry{tag, 1, 3, 0, 1, 0, 0, 0, 16, 0, 0, 0};
    const auto at = std::search(bytes.begin(), bytes.end(), entry.begin(), entry.end());
    ASSERT_NE(at, bytes.end());
    at[8] = 0;
    at[9] = 0x80;
  }
  expect_refused(
      scratch.write("tiles.tif", bytes),
      "has tiles of 32768 x 32768 pixels; must not be larger than the picture; save it without tiles");
}

/// Adds a picture to a file that has one.
void add_page(const std::string& path, int kind, std::uint8_t value) {
  TIFF* tiff = TIFFOpen(path.c_str(), "a");
  TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, kind);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFWriteScanline(tiff, &value, 0, 0);
  TIFFClose(tiff);
}

TEST(PictureTiff, RefusesSeveralPagesButNotAPreview) {
  const Scratch scratch;
  const std::string path = make_tiff<std::uint8_t>(scratch, {}, {1, 2, 3, 4});
  add_page(path, FILETYPE_REDUCEDIMAGE, 9);
  EXPECT_EQ(specimen::read_picture(path).gray.data.doubles(), (std::vector<double>{1, 2, 3, 4}));
  for (const int kind : {0, FILETYPE_PAGE}) {
    (void)make_tiff<std::uint8_t>(scratch, {}, {1, 2, 3, 4});
    add_page(path, FILETYPE_REDUCEDIMAGE, 9);
    add_page(path, kind, 9);
    expect_refused(
        path, "is a TIFF of several pages; must hold one picture; save the right one as a separate file");
  }
}

TEST(PictureTiff, RefusesPreviewsWithoutEnd) {
  const Scratch scratch;
  const std::string path = make_tiff<std::uint8_t>(scratch, {}, {1, 2, 3, 4});
  for (int i = 0; i < 40; ++i) add_page(path, FILETYPE_REDUCEDIMAGE, 9);
  expect_refused(path, "is a TIFF of several pages");
}

TEST(PictureTiff, RefusesKindsThatItCannotRead) {
  const Scratch scratch;
  TiffRecipe recipe;
  recipe.bits = 64;
  recipe.format = SAMPLEFORMAT_COMPLEXINT;
  expect_refused(make_tiff<std::uint64_t>(scratch, recipe, {0, 1, 2, 3}), "samples of 64 bits in format 5");
  recipe.format = SAMPLEFORMAT_UINT;
  expect_refused(make_tiff<std::uint64_t>(scratch, recipe, {0, 1, std::uint64_t{1} << 60U, 3}),
                 "holds numbers above 2^53, the first in row 1, column 0");
}

TEST(PictureTiff, RefusesBeginningsAndSurvivesDamage) {
  const Scratch scratch;
  TiffRecipe recipe{20, 20};
  recipe.compression = COMPRESSION_LZW;
  std::vector<std::uint8_t> data(400);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::uint8_t>(i / 30);
  for (const int tile : {0, 16}) {
    recipe.tile = tile;
    make_tiff(scratch, recipe, data);
    const FileBytes whole = scratch.read("recipe.tif");
    // The last four bytes say that there is no second page; the first one is whole without them.
    EXPECT_LE(specimen_test::read_all_beginnings(scratch, whole), 4);
    specimen_test::survive_damage(scratch, whole);
  }
}

/// Pixel size that is read where the resolution is 4 pixels a unit and ImageJ describes the picture so.
double pixel_size_described(const std::string& description, int resolution_unit = RESUNIT_NONE) {
  const Scratch scratch;
  const std::string path = make_tiff<std::uint8_t>(scratch, {}, {1, 2, 3, 4});
  TIFF* tiff = TIFFOpen(path.c_str(), "r+");
  TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, resolution_unit);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 4.0);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 4.0);
  TIFFRewriteDirectory(tiff);
  TIFFClose(tiff);
  return specimen::read_picture(path).pixel_size;
}

TEST(PictureTiff, TakesTheUnitOfItsScaleFromImageJ) {
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=mm\nmin=0.0\n"), 0.25e-3);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=cm\n"), 0.25e-2);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nimages=1\nunit=\\u00B5m\n"), 0.25e-6);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=micron"), 0.25e-6);
  for (const char* micro : {"\xc2\xb5m", "\xce\xbcm", "\\u03BCm"})
    EXPECT_DOUBLE_EQ(pixel_size_described(std::string("ImageJ=1.53t\nunit=") + micro + "\n"), 0.25e-6)
        << micro;
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=mm\n", RESUNIT_INCH), 0.25e-3)
      << "as ImageJ does";
}

TEST(PictureTiff, TakesTheTagWhereImageJSaysNothing) {
  EXPECT_EQ(pixel_size_described("ImageJ=1.53t\nunit=pixel\n"), 0);
  EXPECT_EQ(pixel_size_described("unit=mm\n"), 0) << "another program's words";
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\n", RESUNIT_CENTIMETER), 0.25e-2);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=furlong\n", RESUNIT_CENTIMETER), 0.25e-2);
}

/// The one pair that ImageJ 1.53t reads per centimetre: it takes the unit for the one to show.
TEST(PictureTiff, TakesTheTagOfCentimetresThatAreShownInMicrometres) {
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=um\n", RESUNIT_CENTIMETER), 0.25e-2);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=um\n", RESUNIT_NONE), 0.25e-6);
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=um\n", RESUNIT_INCH), 0.25e-6);
  for (const char* unit : {"micron", "\\u00B5m"})
    EXPECT_DOUBLE_EQ(
        pixel_size_described(std::string("ImageJ=1.53t\nunit=") + unit + "\n", RESUNIT_CENTIMETER), 0.25e-6)
        << unit;
  EXPECT_DOUBLE_EQ(pixel_size_described("ImageJ=1.53t\nunit=mm\n", RESUNIT_CENTIMETER), 0.25e-3);
}

}  // namespace picture_tiff_test
