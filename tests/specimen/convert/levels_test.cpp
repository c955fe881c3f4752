#include "specimen/convert/levels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/specimen/known_truth.hpp"

namespace levels_test {

using specimen::as_colour;
using specimen::Picture;
using specimen::Raster;
using specimen::Rgb;
using specimen::tame_outliers;

Raster<double> ramp(double low, double high) {
  Raster<double> gray(100, 100);
  for (std::size_t i = 0; i < gray.size(); ++i)
    gray.data[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(gray.size() - 1);
  return gray;
}

TEST(Levels, OneHotPixelIsTamedAndNamed) {
  specimen::GreyLevels gray = ramp(0.02, 0.06);
  gray(17, 33) = 3;
  const std::string note = tame_outliers(gray);
  EXPECT_THAT(note, ::testing::HasSubstr("1 pixel far outside of the range"));
  EXPECT_THAT(note, ::testing::HasSubstr("row 17, column 33 with 3"));
  EXPECT_LT(gray(17, 33), 0.061);
  EXPECT_EQ(tame_outliers(gray), "");
}

TEST(Levels, BytesStayAsTheyAre) {
  specimen::GreyLevels gray = Raster<double>(10, 10, 0.0);
  gray(3, 3) = 255;
  EXPECT_EQ(tame_outliers(gray), "");
  EXPECT_EQ(as_colour(gray)(3, 3), (Rgb{255, 255, 255}));
  gray(3, 3) = 7;
  EXPECT_EQ(as_colour(gray)(3, 3), (Rgb{7, 7, 7}));
}

TEST(Levels, BytesInSixteenBitsAreTheSameBytes) {
  Raster<double> bytes(16, 16), by_257(16, 16), by_256(16, 16);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes.data[i] = static_cast<double>(i % 200 + 30);
    by_257.data[i] = 257 * bytes.data[i];
    by_256.data[i] = 256 * bytes.data[i];
  }
  EXPECT_EQ(as_colour(by_257), as_colour(bytes));
  EXPECT_EQ(as_colour(by_256), as_colour(bytes));
}

TEST(Levels, BytesInAnyUnitAreTheSameBytes) {
  Raster<double> bytes(16, 16), by_16(16, 16);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes.data[i] = static_cast<double>(i % 60 + 3);
    by_16.data[i] = 16 * bytes.data[i];
  }
  EXPECT_EQ(as_colour(by_16), as_colour(bytes));
  specimen::GreyLevels untouched = by_16;
  EXPECT_EQ(tame_outliers(untouched), "");
  Raster<double> four_bits(1, 2);
  four_bits.data = {3, 15};
  EXPECT_EQ(as_colour(four_bits, 4).data, (std::vector<Rgb>{{51, 51, 51}, {255, 255, 255}}));
}

TEST(Levels, ManyLevelsOfADepthAreSharesOfItsWhite) {
  EXPECT_EQ(as_colour(ramp(10'000, 50'000.5)).data.front().r, 39);
  EXPECT_EQ(as_colour(ramp(700, 3000.5)).data.back().r, 187);
  EXPECT_EQ(as_colour(ramp(0.2, 0.8)).data.front().r, 51);
  EXPECT_FALSE(is_spread(ramp(10'000, 50'000.5)));
  EXPECT_TRUE(is_spread(ramp(9000, 21'000.5))) << "too few of 65,536";
  EXPECT_TRUE(is_spread(ramp(-3000, 3000)));
}

TEST(Levels, TheCommonFormHasGreyForGreyAndBytesForBytes) {
  Picture picture;
  picture.colour = Raster<Rgb>(1, 2, Rgb{9, 9, 9});
  const Picture grey = specimen::in_common_form(picture);
  EXPECT_TRUE(grey.colour.empty());
  EXPECT_EQ(grey.gray.data.doubles(), (std::vector<double>{9, 9}));
  Picture fractions;
  fractions.gray = Raster<double>(1, 3);
  fractions.gray.data = std::vector<float>{0, 51 / 255.0F, 1};
  EXPECT_EQ(specimen::in_common_form(fractions).gray.data.doubles(), (std::vector<double>{0, 51, 255}));
  fractions.gray.data = std::vector<double>{0, 0.5, 1};
  EXPECT_EQ(specimen::in_common_form(fractions).gray.data.doubles(), (std::vector<double>{0, 0.5, 1}));
}

TEST(Levels, TheCommonFormHasTheSmallestNumbers) {
  const auto bytes_each = [](std::vector<double> values) {
    Picture picture;
    Raster<double> gray(1, static_cast<int>(values.size()));
    gray.data = std::move(values);
    picture.gray = std::move(gray);
    return specimen::in_common_form(picture).gray.data.visit([](const auto& v) { return sizeof(v.front()); });
  };
  EXPECT_EQ(bytes_each({0, 255}), 1U);
  EXPECT_EQ(bytes_each({0, 256}), 2U);
  for (const double odd : {-1.0, 65536.0, 0.3, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(bytes_each({0, odd}), 8U) << odd;
}

TEST(Levels, OtherRangesAreSpread) {
  const Raster<Rgb> shown = as_colour(ramp(9000, 21000));
  EXPECT_EQ(shown.data.front().r, 0);
  EXPECT_EQ(shown.data.back().r, 255);
  Raster<double> hole = ramp(0, 1000);
  hole(5, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(as_colour(hole)(5, 5), Rgb{});
}

TEST(Levels, GrayStoredAsColoursHasNone) {
  Picture picture;
  picture.colour = Raster<Rgb>(2, 2, Rgb{9, 9, 9});
  EXPECT_FALSE(is_coloured(picture));
  picture.colour(1, 1).b = 10;
  EXPECT_TRUE(is_coloured(picture));
}

}  // namespace levels_test
