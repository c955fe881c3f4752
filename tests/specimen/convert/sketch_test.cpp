#include "specimen/convert/sketch.hpp"

#include <gtest/gtest.h>

#include "tests/specimen/dressed.hpp"

namespace sketch_test {

using specimen::ConvertOptions;
using specimen::Picture;
using specimen::Sketch;

Picture picture_of(int rows, int cols) {
  Picture picture;
  picture.colour = specimen::Raster<specimen::Rgb>(rows, cols, {90, 100, 110});
  picture.pixel_size = 1e-4;
  return picture;
}

TEST(Sketch, SmallPictureStaysAsItIs) {
  const Sketch sketch = specimen::sketch_of(picture_of(30, 40), 1200);
  EXPECT_EQ(sketch.factor, 1);
  EXPECT_EQ(sketch.picture.colour, picture_of(30, 40).colour);
}

TEST(Sketch, LargePictureIsAveraged) {
  const Sketch sketch = specimen::sketch_of(picture_of(301, 400), 20'000);
  EXPECT_EQ(sketch.factor, 3);
  EXPECT_EQ(sketch.picture.rows(), 101);
  EXPECT_EQ(sketch.picture.cols(), 134);
  EXPECT_DOUBLE_EQ(sketch.picture.pixel_size, 3e-4);
  EXPECT_EQ(sketch.rows, 301);
}

TEST(Sketch, LengthsInPixelsAreDivided) {
  const Sketch sketch = specimen::sketch_of(picture_of(300, 400), 20'000);
  ConvertOptions options;
  options.crop = {30, 60, 120, 90};
  options.width = 0.012;
  options.smooth = 12;
  options.open = 1;
  options.close = 0;
  options.pixels = 200;
  options.stroke_lines = {{"mortar", 9, {{30, 60}, {400, 300}}}, {"void", 2, {{3, 3}}}};
  const ConvertOptions divided = specimen::options_for(sketch, options);
  EXPECT_EQ(divided.crop.x, 10);
  EXPECT_EQ(divided.crop.height, 30);
  EXPECT_DOUBLE_EQ(divided.width, 0.012);
  EXPECT_EQ(divided.smooth, 4);
  EXPECT_EQ(divided.open, 1) << "not none";
  EXPECT_EQ(divided.close, 0);
  EXPECT_EQ(divided.median, -1) << "automatic";
  EXPECT_EQ(divided.pixels, 0) << "more than there are";
  EXPECT_EQ(divided.stroke_lines[0].width, 3);
  EXPECT_EQ(divided.stroke_lines[0].points[0], (std::pair<double, double>{10, 20}));
  EXPECT_LE(divided.stroke_lines[0].points[1].first, sketch.picture.cols());
  EXPECT_EQ(divided.stroke_lines[1].width, 1) << "the thinnest that there is";
}

TEST(Sketch, WidthIsThatOfTheColumnsThatAreThere) {
  const Sketch sketch = specimen::sketch_of(picture_of(300, 400), 20'000);  // 134 columns of 3 pixels
  ConvertOptions options;
  options.width = 0.4;
  EXPECT_NEAR(specimen::options_for(sketch, options).width, 0.402, 1e-12);
}

TEST(Sketch, ShowsWhatTheWholePictureGives) {
  const specimen_test::KnownTruth truth = specimen_test::large_truth();
  const auto strokes = specimen_test::some_strokes(truth.labels, 6, 9);
  Picture picture;
  picture.colour = specimen_test::enlarged(specimen_test::dressed(truth.labels, 1), 2);
  ConvertOptions options;
  options.source_pixel_size = 1e-4;
  for (int r = 0; r < strokes.rows; ++r)
    for (int c = 0; c < strokes.cols; ++c)
      if (strokes(r, c) != specimen::no_stroke)
        options.stroke_lines.push_back(
            {specimen::standard_phases()[strokes(r, c)], 2, {{2 * c + 1.0, 2 * r + 1.0}}, "s"});
  const Sketch sketch = specimen::sketch_of(picture, 200'000);
  ASSERT_EQ(sketch.factor, 2);
  const auto found =
      specimen::convert_picture(sketch.picture, specimen::options_for(sketch, options)).segmented;
  EXPECT_DOUBLE_EQ(found.mask.pixel_size, 2e-4);
  int right = 0;
  for (int r = 0; r < found.mask.labels.rows; ++r)
    for (int c = 0; c < found.mask.labels.cols; ++c) right += found.mask.labels(r, c) == truth.labels(r, c);
  EXPECT_GT(right, 0.95 * truth.rows * truth.cols);
}

}  // namespace sketch_test
