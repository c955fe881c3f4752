// Pictures from one known truth: whatever they are stored as, the mask is that of the truth.
#include "specimen/convert/segment_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/specimen/drawn.hpp"
#include "tests/specimen/known_truth.hpp"
#include "tests/specimen/scratch.hpp"

namespace segment_map_test {

using specimen::convert_picture;
using specimen::Converted;
using specimen::ConvertOptions;
using specimen::Picture;
using specimen::Raster;
using specimen::Rgb;
using specimen_test::coded;
using specimen_test::known_truth;
using specimen_test::KnownTruth;
using specimen_test::picture_of;
using specimen_test::share_wrong;
using ::testing::Contains;
using ::testing::HasSubstr;

Converted convert(Picture picture, specimen::Outside outside = specimen::Outside::automatic) {
  ConvertOptions options;
  options.width = 0.16;
  options.outside = outside;
  return convert_picture(std::move(picture), options);
}

std::string refusal(Picture picture) {
  try {
    (void)convert(std::move(picture));
  } catch (const specimen::Error& error) {
    return error.what();
  }
  return "";
}

/// Grey and colour of a photograph of the truth with some noise.
Raster<double> photograph(const KnownTruth& truth, double noise = 8) {
  Raster<double> gray = coded(truth.labels, std::array{25.0, 190.0, 120.0});
  specimen::Random random(4);
  for (double& v : gray.data) v = std::floor(std::max(0.0, v + random.uniform(-noise, noise)));
  return gray;
}

Picture in_colour(const Raster<double>& gray) {
  Picture picture;
  picture.colour = Raster<Rgb>(gray.rows, gray.cols);
  for (std::size_t i = 0; i < gray.size(); ++i) {
    const auto v = static_cast<std::uint8_t>(gray.data[i]);
    picture.colour.data[i] = {v, v, v};
  }
  return picture;
}

/// Indices in any order, and a palette of greys.
Picture with_palette(const Raster<double>& gray) {
  Picture picture = picture_of(gray);
  picture.indices = Raster<std::uint8_t>(gray.rows, gray.cols);
  for (std::size_t i = 0; i < gray.size(); ++i)
    picture.indices.data[i] = static_cast<std::uint8_t>(static_cast<int>(gray.data[i]) * 7 + 3);
  return picture;
}

/// Bytes in another unit: multiplied to fill more bits, or as fractions of white.
Picture in_units_of(double unit, Raster<double> gray, int bits = 16) {
  for (double& v : gray.data) v *= unit;
  Picture picture = picture_of(std::move(gray));
  picture.bits = bits;
  return picture;
}

Raster<float> single(const Raster<double>& gray) {
  Raster<float> values(gray.rows, gray.cols);
  std::transform(gray.data.begin(), gray.data.end(), values.data.begin(),
                 [](double v) { return static_cast<float>(v); });
  return values;
}

std::vector<Picture> all_encodings(const Raster<double>& gray) {
  std::vector<Picture> all{in_colour(gray), with_palette(gray)};
  for (const double unit : {257.0, 256.0, 16.0, 1.0}) all.push_back(in_units_of(unit, gray));
  all.push_back(in_units_of(1 / 255.0, gray, 64));
  all.push_back(in_units_of(1 / 255.0, gray, 32));
  all.back().gray = single(all.back().gray.doubles());
  return all;
}

TEST(SegmentMap, OneMapInAnyEncodingIsOneSpecimen) {
  const KnownTruth truth = known_truth();
  const Raster<double> gray = coded(truth.labels, std::array{0.0, 255.0, 128.0});
  for (const Picture& picture : all_encodings(gray)) {
    const Converted converted = convert(picture);
    EXPECT_EQ(converted.segmented.mask.labels, truth.labels);
    EXPECT_EQ(converted.segmented.inclusions.size(), truth.stones.size());
  }
}

TEST(SegmentMap, OnePhotographInAnyEncodingIsOneSpecimen) {
  const KnownTruth truth = known_truth();
  for (const double light : {1.0, 0.25}) {
    Raster<double> gray = photograph(truth);
    for (double& v : gray.data) v = std::floor(v * light);
    const auto first = convert(picture_of(gray)).segmented.mask.labels;
    EXPECT_LT(share_wrong(first, truth.labels), 0.03);
    for (const Picture& picture : all_encodings(gray))
      EXPECT_EQ(convert(picture).segmented.mask.labels, first);
  }
}

TEST(SegmentMap, APhotographOfMoreLevelsIsTheSameSpecimen) {
  const KnownTruth truth = known_truth();
  Raster<double> fine = coded(truth.labels, std::array{60.0, 190.0, 120.0});
  specimen::Random random(4);
  for (double& v : fine.data) v += random.uniform(-9, 9);
  Raster<double> bytes = fine, sixteen = fine, twelve = fine;
  for (double& v : bytes.data) v = std::round(v);
  for (double& v : sixteen.data) v = std::round(v * 257);
  for (double& v : twelve.data) v = std::round(v * 4095 / 255);
  const auto first = convert(picture_of(bytes)).segmented.mask.labels;
  for (const Raster<double>& gray : {sixteen, twelve})
    EXPECT_LT(share_wrong(convert(picture_of(gray)).segmented.mask.labels, first), 0.002);
}

TEST(SegmentMap, SoftEdgesOfLabelNumbersAreSettledBehindAPaletteToo) {
  const KnownTruth truth = known_truth();
  const Raster<double> gray = specimen_test::drawn_softly(truth, {0, 1, 2});
  const auto first = convert(picture_of(gray)).segmented.mask.labels;
  EXPECT_LT(share_wrong(first, truth.labels), 0.03);
  for (const Picture& picture : all_encodings(gray)) EXPECT_EQ(convert(picture).segmented.mask.labels, first);
}

TEST(SegmentMap, APaletteIsReadByWhatItShows) {
  const KnownTruth truth = known_truth();
  Picture picture = picture_of(coded(truth.labels, std::array{0.0, 200.0, 90.0}));
  picture.indices = Raster<std::uint8_t>(truth.rows, truth.cols);
  for (std::size_t i = 0; i < picture.indices.size(); ++i)  // two indices of each grey, side by side
    picture.indices.data[i] = static_cast<std::uint8_t>(truth.labels.data[i] * 2 + i % 2);
  EXPECT_EQ(convert(picture).segmented.mask.labels, truth.labels);
}

TEST(SegmentMap, GrainsThatShareAColourOfThePaletteStayApart) {
  Picture picture;
  picture.gray = Raster<double>(60, 120, 0.0);
  picture.indices = Raster<std::uint8_t>(60, 120, 0);
  for (int i = 0; i < 6; ++i) {  // touching squares in two greys
    for (int r = 20; r < 40; ++r)
      for (int c = 20 + 12 * i; c < 32 + 12 * i; ++c) {
        picture.gray(r, c) = 100 + 50 * (i / 3);
        picture.indices(r, c) = static_cast<std::uint8_t>(i + 1);
      }
  }
  const Converted converted = convert(picture);
  EXPECT_EQ(converted.report.method, specimen::Segmentation::instances);
  EXPECT_EQ(converted.segmented.inclusions.size(), 6U);
}

TEST(SegmentMap, ALargePhotographIsAveragedAndItsMaskIsAsLargeAsIt) {
  const KnownTruth truth = known_truth();
  constexpr int times = 34;  // just above what is averaged
  Raster<std::uint8_t> large(truth.rows * times, truth.cols * times);
  specimen::Random random(4);
  std::vector<std::uint8_t> noise(997);
  for (std::uint8_t& v : noise) v = static_cast<std::uint8_t>(random.uniform(0, 16));
  for (int r = 0; r < large.rows; ++r)
    for (int c = 0; c < large.cols; ++c)
      large(r, c) = static_cast<std::uint8_t>(std::array{25, 190, 120}[truth.labels(r / times, c / times)] +
                                              noise[static_cast<std::size_t>(r * 31 + c) % noise.size()]);
  Picture picture;
  picture.gray = std::move(large);
  const Converted converted = convert(std::move(picture));
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("averaged squares of 3 x 3 pixels")));
  ASSERT_EQ(converted.segmented.mask.labels.cols, truth.cols * times);
  Raster<std::uint8_t> middles(truth.rows, truth.cols);
  for (int r = 0; r < truth.rows; ++r)
    for (int c = 0; c < truth.cols; ++c)
      middles(r, c) = converted.segmented.mask.labels(r * times + times / 2, c * times + times / 2);
  EXPECT_LT(share_wrong(middles, truth.labels), 0.03);
}

TEST(SegmentMap, OneHotPixelChangesNothing) {
  const KnownTruth truth = known_truth();
  Raster<double> gray = photograph(truth);
  for (double& v : gray.data) v = v / 4000 + 0.02;
  gray(17, 33) = 3;
  const Converted converted = convert(picture_of(gray));
  EXPECT_LT(share_wrong(converted.segmented.mask.labels, truth.labels), 0.03);
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("row 17, column 33")));
}

TEST(SegmentMap, SoftEdgesAreSettledAndCounted) {
  const KnownTruth truth = known_truth();
  const Converted converted = convert(picture_of(specimen_test::drawn_softly(truth, {0, 255, 128})));
  EXPECT_LT(share_wrong(converted.segmented.mask.labels, truth.labels), 0.02);
  EXPECT_EQ(converted.segmented.inclusions.size(), truth.stones.size());
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("between two of 3 tones to the nearer one")));
}

TEST(SegmentMap, AJpegOfLabelNumbersIsRefused) {
  Picture picture = picture_of(coded(known_truth().labels, std::array{0.0, 1.0, 2.0}));
  picture.lossy = true;
  EXPECT_EQ(
      refusal(picture),
      "convert.method: a JPEG with grey levels 0 to 2; label numbers do not survive the compression of JPEG; "
      "save the labels as PNG or TIFF");
}

/// The truth in a disc; beyond it `outside`, or nothing where that is NaN.
Raster<std::uint8_t> core_of(const KnownTruth& truth, Raster<double>& gray, double outside) {
  Raster<std::uint8_t> labels = truth.labels;
  for (int r = 0; r < labels.rows; ++r)
    for (int c = 0; c < labels.cols; ++c)
      if ((r - 60.0) * (r - 60.0) + (c - 80.0) * (c - 80.0) >= 55.0 * 55.0) {
        labels(r, c) = 0;
        gray(r, c) = outside;
      }
  return labels;
}

TEST(SegmentMap, WhatIsOutsideOfACoreIsVoid) {
  const KnownTruth truth = known_truth();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double outside : {0.0, 255.0, nan}) {
    Raster<double> gray = photograph(truth);
    const Raster<std::uint8_t> core = core_of(truth, gray, outside);
    EXPECT_LT(share_wrong(convert(picture_of(gray)).segmented.mask.labels, core), 0.03) << outside;
    Raster<double> map = coded(truth.labels, std::array{0.0, 2.0, 1.0});
    (void)core_of(truth, map, outside);
    const Converted converted = convert(picture_of(map));
    EXPECT_EQ(share_wrong(converted.segmented.mask.labels, core), 0) << outside;
    EXPECT_THAT(converted.report.notes, Contains(HasSubstr("outside of the specimen lies")));
  }
}

TEST(SegmentMap, TransparencyIsVoidUnlessToldOtherwise) {
  const KnownTruth truth = known_truth();
  Raster<double> marked = photograph(truth);
  const Raster<double> gray = marked;
  const Raster<std::uint8_t> core = core_of(truth, marked, -1);
  for (Picture picture : {picture_of(gray), in_colour(gray)}) {
    picture.opacity = Raster<std::uint8_t>(truth.rows, truth.cols, 255);
    for (std::size_t i = 0; i < marked.size(); ++i)
      if (marked.data[i] < 0) picture.opacity.data[i] = 0;
    EXPECT_LT(share_wrong(convert(picture).segmented.mask.labels, core), 0.03);
    EXPECT_GT(share_wrong(convert(picture, specimen::Outside::none).segmented.mask.labels, core), 0.1);
  }
}

TEST(SegmentMap, WhatLiesBelowTransparencyIsWhiteInGreyAsInColour) {
  const KnownTruth truth = known_truth();
  Raster<double> gray(truth.rows, truth.cols);
  Raster<std::uint8_t> opacity(truth.rows, truth.cols, 255);
  for (std::size_t i = 0; i < gray.size(); ++i) {
    opacity.data[i] = i < gray.size() / 5 ? 0 : 255;
    gray.data[i] = opacity.data[i] == 0 ? 0 : truth.labels.data[i] == specimen::phase::aggregate ? 200 : 120;
  }
  Picture grey = picture_of(gray), coloured = in_colour(gray);
  grey.opacity = coloured.opacity = opacity;
  const Converted one = convert(grey, specimen::Outside::none);
  EXPECT_EQ(one.segmented.mask.labels.data,
            convert(coloured, specimen::Outside::none).segmented.mask.labels.data);
  EXPECT_THAT(one.report.notes, Contains(HasSubstr("255 = ")));
}

TEST(SegmentMap, NumberedGrainsAreGrains) {
  const KnownTruth truth = known_truth();
  Raster<std::uint8_t> stones = truth.labels;
  for (std::uint8_t& label : stones.data) label = label == 0 ? 2 : label;
  Picture colours;
  colours.colour = Raster<Rgb>(truth.rows, truth.cols);
  for (std::size_t i = 0; i < truth.instances.size(); ++i) {
    const auto id = static_cast<std::uint8_t>(truth.instances.data[i]);
    colours.colour.data[i] =
        id == 0 ? Rgb{}
                : Rgb{static_cast<std::uint8_t>(40 + 9 * id), static_cast<std::uint8_t>(255 - 7 * id), 90};
  }
  Raster<double> numbers(truth.rows, truth.cols);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers.data[i] = 70001.0 * truth.instances.data[i];
  for (const Picture& picture : {colours, picture_of(numbers)}) {
    const Converted converted = convert(picture);
    EXPECT_EQ(converted.report.method, specimen::Segmentation::instances);
    EXPECT_EQ(converted.segmented.mask.labels, stones);
    EXPECT_EQ(converted.segmented.inclusions.size(), truth.stones.size());
  }
}

specimen::LabelledMask small_mask() {
  specimen::LabelledMask mask;
  mask.pixel_size = 1e-3;
  mask.labels = Raster<std::uint8_t>(40, 60, specimen::phase::mortar);
  specimen_test::draw_disc(mask.labels, 20, 15, 8, specimen::phase::void_);  // as large as the stone
  specimen_test::draw_disc(mask.labels, 20, 45, 8, specimen::phase::aggregate);
  return mask;
}

TEST(SegmentMap, FilesOfThisProgramSayWhatTheyAre) {
  const specimen_test::Scratch scratch;
  for (const char* ending : {".png", ".tif", ".bmp", ".pgm"}) {
    specimen::write_labels(scratch.file(std::string("a") + ending), small_mask());
    EXPECT_EQ(convert(specimen::read_picture(scratch.file(std::string("a") + ending))).segmented.mask.labels,
              small_mask().labels)
        << ending;
  }
  specimen::write_imagej_tiff(scratch.file("j.tif"), small_mask());
  EXPECT_EQ(convert(specimen::read_picture(scratch.file("j.tif"))).segmented.mask.labels,
            small_mask().labels);
}

TEST(SegmentMap, APreviewIsReadByItsColours) {
  const specimen_test::Scratch scratch;
  specimen::write_preview(scratch.file("said.png"), small_mask());
  specimen::write_png(scratch.file("silent.png"), specimen::preview(small_mask()));
  for (const char* name : {"said.png", "silent.png"})
    EXPECT_EQ(convert(specimen::read_picture(scratch.file(name))).segmented.mask.labels, small_mask().labels)
        << name;
}

TEST(SegmentMap, ADrawingIsNoSpecimen) {
  const specimen_test::Scratch scratch;
  specimen::write_png(scratch.file("damage.png"), specimen::preview(small_mask()), 1e-3,
                      specimen::Origin::drawing);
  EXPECT_THAT(refusal(specimen::read_picture(scratch.file("damage.png"))),
              HasSubstr("a drawing of mesopix, made to be looked at"));
}

TEST(SegmentMap, OblongPixelsAreMadeSquare) {
  const KnownTruth truth = known_truth();
  Raster<double> every_second(truth.rows / 2, truth.cols);
  for (int r = 0; r < every_second.rows; ++r)
    for (int c = 0; c < truth.cols; ++c) every_second(r, c) = truth.labels(2 * r, c);
  Picture picture = picture_of(every_second);
  picture.pixel_aspect = 2;
  const Converted converted = convert(picture);
  EXPECT_LT(share_wrong(converted.segmented.mask.labels, truth.labels), 0.03);
  EXPECT_THAT(converted.report.notes, Contains(HasSubstr("the pixels are 2 times as high as wide")));
  ConvertOptions options;
  options.source_pixel_size = 1e-3;
  EXPECT_THROW((void)convert_picture(picture, options), specimen::Error);
}

}  // namespace segment_map_test
