// What a picture makes of these numbers is tested with the pictures of points that have moved.
#include "apps/drawing/deformed_picture.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace nearest_points_test {

using output::nearest_points;
using output::PointPlace;
using specimen::Raster;

/// Two rows of three pixels of 2 mm.
specimen::LabelledMask small_mask() {
  specimen::LabelledMask mask;
  mask.pixel_size = 2e-3;
  mask.labels = Raster<std::uint8_t>(2, 3);
  return mask;
}

Raster<std::int32_t> numbers(int rows, int cols, std::vector<std::int32_t> values) {
  Raster<std::int32_t> raster(rows, cols);
  raster.data = std::move(values);
  return raster;
}

TEST(NearestPoints, PutsTheFirstRowOnTop) {
  const std::vector<PointPlace> points{{1e-3, 3e-3}, {5e-3, 3e-3}, {3e-3, 1e-3}};
  EXPECT_EQ(nearest_points(small_mask(), points, 1), numbers(2, 3, {0, -1, 1, -1, 2, -1}));
}

TEST(NearestPoints, GivesAPixelToTheNearerOfTwo) {
  EXPECT_EQ(nearest_points(small_mask(), {{1.3e-3, 1e-3}, {1.1e-3, 1e-3}}, 1),
            numbers(2, 3, {-1, -1, -1, 1, -1, -1}));
}

TEST(NearestPoints, LeavesOutWhatIsNowhereOrFarAway) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(nearest_points(small_mask(), {{nan, 1e-3}, {1e-3, infinity}}, 1),
            numbers(2, 3, {-1, -1, -1, -1, -1, -1}));
  const Raster<std::int32_t> far =
      nearest_points(small_mask(), {{1e300, 1e-3}, {1e-3, -1e300}, {1e-3, 1e-3}}, 1);
  EXPECT_EQ(std::count(far.data.begin(), far.data.end(), 2), 1);
  EXPECT_EQ(std::count(far.data.begin(), far.data.end(), -1), static_cast<std::ptrdiff_t>(far.size()) - 1);
  EXPECT_LE(far.cols, 5);
  EXPECT_LE(far.rows, 3);
}

}  // namespace nearest_points_test
