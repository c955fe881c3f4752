#include "specimen/convert/image_colour.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace image_distance_test {

using specimen::Raster;

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

}  // namespace image_distance_test
