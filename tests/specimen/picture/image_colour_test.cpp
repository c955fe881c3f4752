#include "specimen/picture/image_colour.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace image_colour_test {

using specimen::Raster;
using specimen::Rgb;

Raster<Rgb> one(Rgb colour) { return Raster<Rgb>(1, 1, colour); }
double channel(Rgb colour, const char* name) { return specimen::channel_of(one(colour), name)(0, 0); }

TEST(ImageColour, IsWrittenAsInAStyleSheet) { EXPECT_EQ(specimen::colour_text({112, 128, 5}), "#708005"); }

TEST(ImageColour, LabOfTheCornersOfTheColourCube) {
  // CIE 1976 from sRGB and D65, as tabulated; the 8-bit codes round to 0.4 in L and 1 in a and b.
  const auto expect_lab = [](Rgb colour, double l, double a, double b) {
    const specimen::Lab lab = specimen::to_lab(one(colour))(0, 0);
    EXPECT_NEAR(lab.l(), l, 0.5);
    EXPECT_NEAR(lab.a(), a, 1);
    EXPECT_NEAR(lab.b(), b, 1);
  };
  expect_lab({255, 255, 255}, 100, 0, 0);
  expect_lab({0, 0, 0}, 0, 0, 0);
  expect_lab({255, 0, 0}, 53.24, 80.09, 67.20);
  expect_lab({0, 255, 0}, 87.73, -86.18, 83.18);
  expect_lab({0, 0, 255}, 32.30, 79.19, -107.86);
  expect_lab({128, 128, 128}, 53.59, 0, 0);
}

TEST(ImageColour, ChannelsHaveTheRangesThatAreDeclared) {
  const Rgb orange{255, 128, 0};
  EXPECT_EQ(channel(orange, "red"), 255);
  EXPECT_EQ(channel(orange, "green"), 128);
  EXPECT_EQ(channel(orange, "blue"), 0);
  EXPECT_EQ(channel(orange, "value"), 255);
  EXPECT_EQ(channel(orange, "saturation"), 255);
  EXPECT_NEAR(channel(orange, "hue"), 30.1, 0.05);
  EXPECT_NEAR(channel({255, 0, 128}, "hue"), 329.9, 0.05);
  EXPECT_NEAR(channel({0, 255, 0}, "hue"), 120, 1e-9);
  EXPECT_NEAR(channel({0, 0, 255}, "hue"), 240, 1e-9);
  EXPECT_EQ(channel({7, 7, 7}, "hue"), 0);
  EXPECT_EQ(channel({7, 7, 7}, "saturation"), 0);
  EXPECT_DOUBLE_EQ(channel({10, 20, 30}, "gray"), 0.299 * 10 + 0.587 * 20 + 0.114 * 30);
  EXPECT_NEAR(channel({255, 0, 0}, "l"), 53.24, 0.5);
  EXPECT_NEAR(channel({255, 0, 0}, "a"), 80.09, 1);
  EXPECT_NEAR(channel({0, 0, 255}, "b"), -107.86, 1);
}

TEST(ImageColour, MedianTakesASpeckAwayAndKeepsARim) {
  Raster<Rgb> picture(9, 9, Rgb{10, 10, 10});
  for (int r = 0; r < 9; ++r)
    for (int c = 5; c < 9; ++c) picture(r, c) = {200, 0, 0};
  const Raster<Rgb> rim = picture;
  picture(4, 1) = {255, 255, 255};
  EXPECT_EQ(specimen::median_of(picture, 3), rim);
}

TEST(ImageDistance, IsEuclideanFromCentreToCentre) {
  Raster<std::uint8_t> mask(9, 11, 1);
  mask(2, 3) = 0;
  mask(8, 10) = 0;
  const Raster<float> distance = specimen::distance_to_zero(mask);
  for (int r = 0; r < 9; ++r)
    for (int c = 0; c < 11; ++c)
      EXPECT_NEAR(distance(r, c), std::min(std::hypot(r - 2, c - 3), std::hypot(r - 8, c - 10)), 1e-5);
}

TEST(ImageDistance, IsLargeWhereThereIsNoZero) {
  for (const float d : specimen::distance_to_zero(Raster<std::uint8_t>(3, 4, 1)).data) EXPECT_GE(d, 5);
}

}  // namespace image_colour_test
