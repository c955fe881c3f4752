#include "specimen/picture/image_libraries.hpp"

#include <gtest/gtest.h>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace image_libraries_test {

TEST(ImageCorrelation, CountsEveryPairOnceAndNoneRoundTheEdge) {
  Raster<std::uint8_t> set(23, 31);
  Random random(1);
  for (std::uint8_t& one : set.data) one = random.uniform() < 0.4 ? 1 : 0;
  const int most = 11;
  const Raster<std::int64_t> pairs = count_pairs(set, most);
  ASSERT_EQ(pairs.rows, most + 1);
  ASSERT_EQ(pairs.cols, 2 * most + 1);
  for (int down = 0; down <= most; ++down) {
    for (int right = -most; right <= most; ++right) {
      std::int64_t expected = 0;
      for (int row = 0; row < set.rows; ++row)
        for (int col = 0; col < set.cols; ++col)
          expected += set.contains(row + down, col + right) && set(row, col) == 1 &&
                      set(row + down, col + right) == 1;
      EXPECT_EQ(pairs(down, most + right), expected) << down << ' ' << right;
    }
  }
}

TEST(ImageCorrelation, OfOnePixelKnowsNoOtherShift) {
  EXPECT_EQ(count_pairs({1, 1, 1}, 0)(0, 0), 1);
  EXPECT_EQ(count_pairs({1, 1, 0}, 0)(0, 0), 0);
}

}  // namespace image_libraries_test
}  // namespace specimen
