#include "specimen/convert/convert_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "specimen/body/error.hpp"

namespace convert_options_test {

using specimen::check_options;
using specimen::ConvertOptions;
using specimen::ConvertReport;
using specimen::Error;
using specimen::Picture;
using specimen::Raster;
using specimen::Segmentation;

/// What the check says of options that were changed like this.
std::string complaint(const std::function<void(ConvertOptions&)>& change) {
  ConvertOptions options;
  change(options);
  try {
    check_options(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ConvertOptions, DefaultsAreFine) {
  EXPECT_EQ(complaint([](auto&) {}), "");
}

TEST(ConvertOptions, EachValueIsChecked) {
  EXPECT_EQ(complaint([](auto& o) { o.median = 4; }),
            "convert.median: 4 px; odd, 1 to 255; 0 = none, -1 = automatic");
  EXPECT_EQ(complaint([](auto& o) { o.open = -2; }), "convert.open: -2 px; 0 to 10,000; -1 = automatic");
  EXPECT_EQ(complaint([](auto& o) { o.close = 20000; }),
            "convert.close: 20000 px; 0 to 10,000; -1 = automatic");
  EXPECT_EQ(complaint([](auto& o) { o.drop_islands = -2; }),
            "convert.drop_islands: -2 m2; must be >= 0; -1 = automatic");
  EXPECT_EQ(complaint([](auto& o) { o.split_depth = 1; }),
            "convert.split_depth: 1; must lie between 0 and 1");
  EXPECT_EQ(complaint([](auto& o) { o.classes = 17; }), "convert.classes: 17; 2 to 16, or 0 for automatic");
  EXPECT_EQ(complaint([](auto& o) { o.pixels = -1; }),
            "convert.pixels: -1; 1 to 100,000; 0 = as the picture");
  EXPECT_EQ(complaint([](auto& o) { o.width = -0.15; }),
            "convert.width: -150 mm; must be > 0; omit it to use the resolution tag of the file");
  EXPECT_EQ(complaint([](auto& o) { o.source_pixel_size = std::nan(""); }),
            "convert.pixel_size: nan mm; must be > 0; omit it to use the resolution tag of the file");
  EXPECT_EQ(complaint([](auto& o) { o.channel = "grey"; }),
            "convert.channel: grey; gray, red, green, blue, hue, saturation, value, l, a, b are known");
}

TEST(ConvertOptions, StrokesAndModelsLeaveNothingElseToChoose) {
  EXPECT_EQ(complaint([](auto& o) {
              o.strokes = "s.png";
              o.model = "m.mesomodel";
            }),
            "convert.model: given beside strokes; one of the two sorts a picture; leave the model out to "
            "teach a new "
            "one");
  EXPECT_EQ(complaint([](auto& o) {
              o.strokes = "s.png";
              o.method = Segmentation::kmeans;
            }),
            "convert.strokes: given with method kmeans; belongs to method taught");
  EXPECT_EQ(complaint([](auto& o) { o.method = Segmentation::taught; }),
            "convert.strokes: none given; method taught needs strokes or a model; paint some on each phase, "
            "on a layer "
            "over the picture");
  EXPECT_EQ(
      complaint([](auto& o) {
        o.strokes = "s.png";
        o.classes = 3;
      }),
      "convert.classes: given beside convert.strokes; it has no effect on what strokes teach; leave it out");
  EXPECT_EQ(complaint([](auto& o) {
              o.model = "m.mesomodel";
              o.even_light = true;
            }),
            "convert.even_light: given beside a model; a model says itself whether the light is evened out; "
            "leave it "
            "out");
  EXPECT_EQ(
      complaint([](auto& o) { o.smooth = 4; }),
      "convert.smooth: 4 px without strokes; it belongs to method taught; use median for other methods");
}

TEST(ConvertOptions, OptionsThatTheMethodWouldPassOverAreRefused) {
  EXPECT_EQ(complaint([](auto& o) {
              o.method = Segmentation::otsu;
              o.thresholds = {3};
            }),
            "convert.thresholds: given with method otsu; they belong to method threshold");
  EXPECT_EQ(complaint([](auto& o) {
              o.method = Segmentation::kmeans;
              o.label_phases = {{1, "mortar"}};
            }),
            "convert.label_phases: given with method kmeans; they belong to labels and taught");
  EXPECT_EQ(complaint([](auto& o) {
              o.method = Segmentation::labels;
              o.class_phases = {"void", "mortar"};
            }),
            "convert.class_phases: given with method labels; they belong to thresholds and kmeans; use "
            "label_phases "
            "for a map");
  EXPECT_EQ(complaint([](auto& o) {
              o.method = Segmentation::otsu;
              o.classes = 3;
            }),
            "convert.classes: 3 with method otsu; they belong to multi_otsu and kmeans");
  EXPECT_EQ(complaint([](auto& o) {
              o.method = Segmentation::kmeans;
              o.channel = "hue";
            }),
            "convert.channel: hue with method kmeans; a channel belongs to threshold, otsu and multi_otsu");
  EXPECT_EQ(
      complaint([](auto& o) { o.source_pixel_size = o.width = 1; }),
      "convert.pixel_size: 1000 mm beside a width of 1000 mm; one of them sets the scale; leave one out");
}

TEST(ConvertOptions, ListsMustFitTogether) {
  EXPECT_EQ(complaint([](auto& o) {
              o.thresholds = {20, 10};
            }),
            "convert.thresholds: 10; must be finite and rise");
  EXPECT_EQ(
      complaint([](auto& o) { o.method = Segmentation::threshold; }),
      "convert.thresholds: none given; method threshold needs at least one; give the grey levels between the "
      "phases, or use method otsu");
  EXPECT_EQ(complaint([](auto& o) {
              o.thresholds = {1, 2};
              o.class_phases = {"void", "mortar"};
            }),
            "convert.class_phases: 2 names; there are 3 classes; name every class, darkest first");
  EXPECT_EQ(complaint([](auto& o) {
              o.class_phases = {"void", ""};
            }),
            "convert.class_phases: an empty name; every class needs a phase");
  EXPECT_EQ(complaint([](auto& o) {
              o.label_phases = {{1, "mortar"}, {1, "void"}};
            }),
            "convert.label_phases: value 1 twice; each value has one phase");
  EXPECT_EQ(complaint([](auto& o) { o.thresholds = {1, 2}; }), "");
  EXPECT_EQ(complaint([](auto& o) { o.class_phases = {"void", "mortar"}; }), "");
}

Picture counting_picture() {
  Picture picture;
  picture.gray = Raster<double>(3, 4);
  for (std::size_t i = 0; i < 12; ++i) picture.gray.data[i] = static_cast<double>(i);
  return picture;
}

TEST(ConvertOptions, CropKeepsARectangle) {
  const Picture part = specimen::cropped(counting_picture(), {1, 1, 2, 2});
  EXPECT_EQ(part.gray.data.doubles(), (std::vector<double>{5, 6, 9, 10}));
  EXPECT_EQ(specimen::cropped(counting_picture(), {}).gray, counting_picture().gray);
}

TEST(ConvertOptions, CropMustLieInThePicture) {
  for (const specimen::Crop crop :
       {specimen::Crop{1, 1, 4, 2}, specimen::Crop{0, 0, 4, 0}, specimen::Crop{-1, 0, 2, 2},
        specimen::Crop{0, 2147483647, 1, 1}, specimen::Crop{2, 0, 2147483647, 1}})
    EXPECT_THROW((void)specimen::cropped(counting_picture(), crop), Error);
  try {
    (void)specimen::cropped(counting_picture(), {1, 2, 3, 2});
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "convert.crop: 3 x 2 px at column 1, row 2; must lie within the picture of 4 x 3 px");
  }
}

TEST(ConvertOptions, ScaleIsAsGivenElseTheTagElseAnError) {
  Picture picture = counting_picture();
  ConvertOptions options;
  ConvertReport report;
  try {
    (void)specimen::source_pixel_size(picture, options, report);
    FAIL();
  } catch (const specimen::NoScale& error) {
    EXPECT_STREQ(error.what(),
                 "convert.pixel_size: not given, and the file has no scale; the scale is needed; give "
                 "source_pixel_size or width");
  }
  picture.pixel_size = 0.0254 / 2400;
  EXPECT_EQ(specimen::source_pixel_size(picture, options, report), 0.0254 / 2400);
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_THAT(report.notes.front(), ::testing::HasSubstr("0.01058 mm per pixel (2400 dpi)"));
  EXPECT_THAT(report.notes.front(), ::testing::HasSubstr("unconfirmed"));
  options.width = 0.2;
  EXPECT_EQ(specimen::source_pixel_size(picture, options, report), 0.05);
  options.width = 0;
  options.source_pixel_size = 0.5e-3;
  EXPECT_EQ(specimen::source_pixel_size(picture, options, report), 0.5e-3);
  EXPECT_EQ(report.notes.size(), 1U);
}

}  // namespace convert_options_test
