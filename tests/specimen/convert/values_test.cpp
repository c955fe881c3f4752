#include "specimen/convert/guess.hpp"

#include <gtest/gtest.h>

namespace values_test {

using specimen::distinct_values;
using specimen::Picture;
using specimen::Raster;

Picture gray(int cols, std::vector<double> values) {
  Picture picture;
  picture.gray = Raster<double>(static_cast<int>(values.size()) / cols, cols);
  picture.gray.data = std::move(values);
  return picture;
}

TEST(Values, AreListedInRisingOrderWithACodePerPixel) {
  const auto map = distinct_values(gray(3, {255, -4, 70000, 255, 255, -4}), 10);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{-4, 255, 70000}));
  EXPECT_EQ(map->code.data, (std::vector<std::int32_t>{1, 0, 2, 1, 1, 0}));
  EXPECT_EQ(specimen::value_text(*map, 0), "-4");
}

TEST(Values, AreNoneWhereTheyAreTooManyOrFractions) {
  EXPECT_TRUE(distinct_values(gray(3, {1, 2, 3}), 3));
  EXPECT_FALSE(distinct_values(gray(3, {1, 2, 3}), 2));
  EXPECT_FALSE(distinct_values(gray(2, {1, 2.5}), 9));
  EXPECT_FALSE(distinct_values(gray(2, {1, 1e300}), 9));
}

TEST(Values, OfAPaletteAreItsIndices) {
  Picture picture = gray(2, {90, 10});
  picture.indices = Raster<std::uint8_t>(1, 2);
  picture.indices.data = {4, 3};
  EXPECT_EQ(distinct_values(picture, 9)->values, (std::vector<std::int64_t>{3, 4}));
}

TEST(Values, OfColoursAreTheirHexadecimalNumbers) {
  Picture picture;
  picture.colour = Raster<specimen::Rgb>(1, 2, {255, 128, 1});
  const auto map = distinct_values(picture, 9);
  EXPECT_TRUE(map->colours);
  EXPECT_EQ(map->values, (std::vector<std::int64_t>{0xff8001}));
  EXPECT_EQ(specimen::value_text(*map, 0), "#ff8001");
}

TEST(Values, CoherenceIsOneForAMapAndLowForNoise) {
  EXPECT_EQ(specimen::coherence(*distinct_values(gray(4, {5, 5, 5, 5}), 9)), 1);
  EXPECT_EQ(specimen::coherence(*distinct_values(gray(4, {5, 6, 5, 6}), 9)), 0);
  EXPECT_DOUBLE_EQ(specimen::coherence(*distinct_values(gray(4, {5, 5, 6, 6}), 9)), 2.0 / 3);
}

TEST(Values, LargestPieceOfEach) {
  const auto map = distinct_values(gray(5, {1, 1, 2, 1, 3,  //
                                            1, 2, 2, 1, 1}),
                                   9);
  EXPECT_EQ(specimen::largest_pieces(map->code, 3), (std::vector<std::int64_t>{3, 3, 1}));
}

}  // namespace values_test
