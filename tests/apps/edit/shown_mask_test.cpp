#include "apps/edit/shown_mask.hpp"

#include <gtest/gtest.h>

namespace shown_mask_test {

using app::boundary_flag;
using app::ShownMask;
using app::uncertain_flag;

/// Two grains side by side, mortar below.
specimen::Segmented two_grains() {
  specimen::Segmented segmented;
  segmented.mask.labels = specimen::Raster<std::uint8_t>(3, 4, 1);
  segmented.mask.pixel_size = 1e-3;
  segmented.instances = specimen::Raster<std::int32_t>(3, 4, 1);
  for (int c = 0; c < 4; ++c) {
    segmented.mask.labels(2, c) = 2;
    segmented.instances(2, c) = 0;
    for (int r = 0; r < 2; ++r) segmented.instances(r, c) = c < 2 ? 1 : 2;
  }
  return segmented;
}

TEST(ShownMask, HasLabelsBoundariesAndDoubts) {
  specimen::Raster<std::uint8_t> uncertain(6, 8, 0);  // 2 x 2 for each pixel of the mask
  uncertain(1, 1) = 1;
  const ShownMask shown = app::shown_mask(two_grains(), uncertain, {}, 4, 1);
  ASSERT_EQ(shown.bytes.size(), 24U);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      const auto at = static_cast<std::size_t>(4 * r + c);
      EXPECT_EQ(shown.bytes[at], r < 2 ? 1 : 2);
      const bool ends = r == 1 || (r == 0 && c == 1);
      EXPECT_EQ(shown.bytes[12 + at], (ends ? boundary_flag : 0) | (r + c == 0 ? uncertain_flag : 0))
          << r << " " << c;
    }
}

TEST(ShownMask, LiesOnThePartOfThePictureThatItCovers) {
  const ShownMask shown = app::shown_mask(two_grains(), {}, {10, 20, 200, 150}, 1000, 2);
  EXPECT_EQ(shown.x, 10);
  EXPECT_EQ(shown.y, 20);
  EXPECT_EQ(shown.step_x, 50);
  EXPECT_EQ(shown.step_y, 25) << "the pixels of the picture are twice as high as wide";
  EXPECT_EQ(app::shown_mask(two_grains(), {}, {}, 1000, 1).step_x, 250);
}

TEST(ShownMask, LargeOneIsThinned) {
  specimen::Segmented large;
  large.mask.labels = specimen::Raster<std::uint8_t>(3000, 4000, 2);
  large.instances = specimen::Raster<std::int32_t>(3000, 4000, 0);
  const ShownMask shown = app::shown_mask(large, {}, {}, 4000, 1);
  EXPECT_EQ(shown.cols, 2000);
  EXPECT_EQ(shown.rows, 1500);
  EXPECT_EQ(shown.step_x, 2);
}

TEST(ShownPicture, IsRedGreenBlueAndNoLargerThanAsked) {
  specimen::Picture picture;
  picture.colour = specimen::Raster<specimen::Rgb>(20, 30, {1, 2, 3});
  const app::ShownPicture whole = app::shown_picture(picture, 1000);
  EXPECT_EQ(whole.bytes.size(), 1800U);
  EXPECT_EQ(whole.bytes.substr(0, 6), "\1\2\3\1\2\3");
  const app::ShownPicture part = app::shown_picture(picture, 150);
  EXPECT_EQ(part.cols, 15);
  EXPECT_EQ(part.rows, 10);
}

}  // namespace shown_mask_test
