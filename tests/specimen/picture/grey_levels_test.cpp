#include "specimen/picture/grey_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace grey_levels_test {

using specimen::GreyLevels;
using specimen::Numbers;
using specimen::Raster;

std::size_t bytes_each(const Numbers& numbers) {
  return numbers.visit([](const auto& values) { return sizeof(values.front()); });
}

TEST(GreyLevels, AreReadAsTheyWereStored) {
  const Numbers bytes = std::vector<std::uint8_t>{0, 255};
  EXPECT_EQ(bytes[1], 255);
  EXPECT_EQ(bytes_each(bytes), 1U);
  EXPECT_EQ(Numbers(std::vector<float>{0.5F}).doubles(), (std::vector<double>{0.5}));
  EXPECT_EQ(bytes, Numbers(std::vector<double>{0, 255})) << "the same numbers in another storage";
}

TEST(GreyLevels, WidenForANumberThatDoesNotFit) {
  GreyLevels levels = Raster<std::uint8_t>(1, 2, 7);
  levels(0, 1) = 200;
  EXPECT_EQ(bytes_each(levels.data), 1U);
  for (const double odd : {256.0, -1.0, 0.5}) {
    GreyLevels wide = levels;
    wide(0, 0) = odd;
    EXPECT_EQ(wide.data.doubles(), (std::vector<double>{odd, 200}));
  }
  GreyLevels hole = levels;
  hole(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(hole.data[0]));
  EXPECT_EQ(hole.data[1], 200);
}

TEST(GreyLevels, ChangeTheirFormWithoutTheirStorage) {
  const GreyLevels levels = Raster<std::uint16_t>(2, 3, 9);
  const GreyLevels turned = levels.with([](const auto& raster) {
    auto other = raster;
    other.rows = raster.cols;
    other.cols = raster.rows;
    return other;
  });
  EXPECT_EQ(turned.rows, 3);
  EXPECT_EQ(bytes_each(turned.data), 2U);
}

}  // namespace grey_levels_test
