#include "specimen/picture/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/specimen/picture_checks.hpp"

namespace picture_test {

using specimen::LabelledMask;
using specimen::phase_colour;
using specimen::Picture;
using specimen::Rgb;
using specimen_test::Scratch;

LabelledMask mask_of_all_labels(double pixel_size) {
  LabelledMask mask;
  mask.labels = specimen::Raster<std::uint8_t>(14, 19);  // neither side a multiple of four
  for (std::size_t i = 0; i < mask.labels.size(); ++i) mask.labels.data[i] = static_cast<std::uint8_t>(i);
  mask.pixel_size = pixel_size;
  return mask;
}

class LabelFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(LabelFormats, BringBackEveryLabel) {
  const Scratch scratch;
  const LabelledMask mask = mask_of_all_labels(0.5e-3);
  const std::string path = scratch.file(std::string("labels") + GetParam());
  specimen::write_labels(path, mask);
  const Picture picture = specimen::read_picture(path);
  ASSERT_EQ(picture.rows(), 14);
  ASSERT_EQ(picture.cols(), 19);
  for (std::size_t i = 0; i < picture.gray.size(); ++i) ASSERT_EQ(picture.gray.data[i], mask.labels.data[i]);
  EXPECT_EQ(scratch.files(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Picture, LabelFormats, ::testing::Values(".png", ".tif", ".TIFF", ".bmp", ".pgm"),
                         [](const auto& about) { return std::string(about.param).substr(1); });

TEST(Picture, TiffKeepsAnyScaleToOneInAMillion) {
  const Scratch scratch;
  for (const double pixel_size : {0.5e-3, 0.0254 / 2400, 0.39e-3, 1e-3 / 3, 7.77e-6}) {
    specimen::write_labels(scratch.file("a.tif"), mask_of_all_labels(pixel_size));
    EXPECT_NEAR(specimen::read_picture(scratch.file("a.tif")).pixel_size / pixel_size, 1, 1e-6);
  }
}

TEST(Picture, PngAndBmpKeepTheScaleToAWholeNumberOfPixelsPerMetre) {
  const Scratch scratch;
  for (const char* name : {"a.png", "a.bmp"}) {
    specimen::write_labels(scratch.file(name), mask_of_all_labels(0.5e-3));
    EXPECT_DOUBLE_EQ(specimen::read_picture(scratch.file(name)).pixel_size, 0.5e-3);
    specimen::write_labels(scratch.file(name), mask_of_all_labels(0.39e-3));
    EXPECT_DOUBLE_EQ(specimen::read_picture(scratch.file(name)).pixel_size, 1.0 / 2564);
  }
}

TEST(Picture, TrustsTheFirstBytesNotTheName) {
  const Scratch scratch;
  specimen::write_labels(scratch.file("a.tif"), mask_of_all_labels(1));
  std::filesystem::rename(scratch.file("a.tif"), scratch.file("a.jpg"));
  EXPECT_EQ(specimen::read_picture(scratch.file("a.jpg")).cols(), 19);
}

TEST(Picture, RefusesWhatIsNoPicture) {
  const Scratch scratch;
  specimen_test::expect_refused(
      scratch.write("notes.png", std::string("just some text")),
      "is not in a known picture format; PNG, TIFF, BMP, JPEG, PGM and PPM are read");
  specimen_test::expect_refused(scratch.write("empty.png", std::string()),
                                "is not in a known picture format");
  specimen_test::expect_refused(
      scratch.write("specimen.h5", std::string("\x89HDF\r\n\x1a\n")),
      "is an HDF5 file; PNG, TIFF, BMP, JPEG, PGM and PPM are read; "
      "a specimen of mesopix needs no conversion: give it to the next command as it is; export labels of "
      "another program, such as exported_data of ilastik, as PNG or TIFF");
}

TEST(Picture, TellsItsSizeBeforeItsPixels) {
  const Scratch scratch;
  for (const char* name : {"a.png", "a.tif", "a.bmp", "a.pgm"}) {
    specimen::write_labels(scratch.file(name), mask_of_all_labels(1));
    std::vector<std::int64_t> told;
    (void)specimen::read_picture(scratch.file(name), 1'000'000, [&](std::int64_t rows, std::int64_t cols) {
      told.insert(told.end(), {rows, cols});
    });
    const specimen::Picture picture = specimen::read_picture(scratch.file(name));
    EXPECT_EQ(told, (std::vector<std::int64_t>{picture.rows(), picture.cols()})) << name;
  }
}

TEST(Picture, RefusesMorePixelsThanAllowed) {
  const Scratch scratch;
  for (const char* name : {"a.png", "a.tif", "a.bmp", "a.pgm"}) {
    specimen::write_labels(scratch.file(name), mask_of_all_labels(1));
    EXPECT_EQ(specimen::read_picture(scratch.file(name), 14 * 19).rows(), 14);
    EXPECT_THROW((void)specimen::read_picture(scratch.file(name), 14 * 19 - 1), specimen::Error) << name;
  }
}

TEST(Picture, WritesLabelsInKnownFormatsAlone) {
  const Scratch scratch;
  for (const char* name : {"labels.jpg", "labels", ".hidden/labels"}) try {
      specimen::write_labels(scratch.file(name), mask_of_all_labels(1));
      ADD_FAILURE() << name;
    } catch (const specimen::Error& error) {
      EXPECT_EQ(error.fault, specimen::Fault::write);
      EXPECT_THAT(error.what(),
                  ::testing::HasSubstr("labels are written as .png, .tif, .tiff, .bmp or .pgm"));
    }
}

int distance(Rgb p, Rgb q) { return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b); }

TEST(Preview, GivesThePhasesTheColoursOfTheLegend) {
  EXPECT_EQ(phase_colour(specimen::phase::void_), (Rgb{255, 255, 255}));
  const Rgb aggregate = phase_colour(specimen::phase::aggregate);
  EXPECT_TRUE(aggregate.b > aggregate.g && aggregate.g > aggregate.r) << "blue-grey";
  const Rgb itz = phase_colour(specimen::phase::itz);
  EXPECT_TRUE(itz.r > itz.g && itz.g > itz.b) << "dark orange";
}

TEST(Preview, KeepsThePhasesApart) {
  for (int first = 0; first < 24; ++first)
    for (int second = 0; second < first; ++second)
      EXPECT_GE(distance(phase_colour(static_cast<std::uint8_t>(first)),
                         phase_colour(static_cast<std::uint8_t>(second))),
                20)
          << first << " and " << second;
}

TEST(Overlay, ShowsThePhotographAndTheMaskOverIt) {
  specimen::LabelledMask mask;
  mask.labels = specimen::Raster<std::uint8_t>(2, 3, specimen::phase::mortar);
  mask.labels(0, 2) = specimen::phase::aggregate;
  const Rgb grey{100, 100, 100};
  const specimen::Raster<Rgb> photograph(8, 12, grey);
  const specimen::Raster<Rgb> both = specimen::overlay(photograph, mask);
  ASSERT_EQ(both.rows, 8);
  ASSERT_EQ(both.cols, 12 + 12 + 12);
  EXPECT_EQ(both(3, 11), grey) << "the photograph as it is";
  const Rgb mortar = phase_colour(specimen::phase::mortar);
  EXPECT_EQ(both(6, 24), (Rgb{static_cast<std::uint8_t>((100 + mortar.r) / 2),
                              static_cast<std::uint8_t>((100 + mortar.g) / 2),
                              static_cast<std::uint8_t>((100 + mortar.b) / 2)}));
  EXPECT_EQ(both(1, 24 + 7), (Rgb{0, 0, 0})) << "where mortar and aggregate meet";
  EXPECT_EQ(both(3, 24 + 9), (Rgb{0, 0, 0}));
  EXPECT_NE(both(1, 24 + 10), (Rgb{0, 0, 0}));
  const Scratch scratch;
  specimen::write_overlay(scratch.file("o.png"), photograph, mask);
  EXPECT_EQ(specimen::read_picture(scratch.file("o.png")).origin, specimen::Origin::drawing);
}

TEST(Preview, ShowsEveryPixelWhereItIs) {
  specimen::LabelledMask mask;
  mask.labels = specimen::Raster<std::uint8_t>(2, 3, specimen::phase::mortar);
  mask.labels(0, 2) = specimen::phase::itz;
  mask.labels(1, 0) = 255;
  const specimen::Raster<Rgb> picture = specimen::preview(mask);
  ASSERT_EQ(picture.rows, 2);
  ASSERT_EQ(picture.cols, 3);
  for (int row = 0; row < 2; ++row)
    for (int col = 0; col < 3; ++col) EXPECT_EQ(picture(row, col), phase_colour(mask.labels(row, col)));
}

}  // namespace picture_test
