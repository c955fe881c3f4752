#include "specimen/teach/even_light.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace even_light_test {

using specimen::Lab;
using specimen::Raster;

/// A grey wall, lit twice as brightly at its left edge; a dark stone covers a quarter of it.
Raster<Lab> lit(bool with_stone) {
  Raster<Lab> picture(120, 160);
  for (int r = 0; r < 120; ++r)
    for (int c = 0; c < 160; ++c) {
      const double light = std::cbrt(2 - c / 159.0);
      const bool stone = with_stone && r > 60 && c > 80;
      picture(r, c).l_code = static_cast<std::uint8_t>(std::lround(((stone ? 30 : 66) * light - 16) * 2.55));
    }
  return picture;
}

TEST(EvenLight, WallIsEvenAfterwardsAndTheRatioIsTold) {
  Raster<Lab> picture = lit(false);
  EXPECT_NEAR(specimen::even_light(picture), 2, 0.1);
  for (int c = 0; c < 160; ++c) EXPECT_NEAR(picture(60, c).l(), picture(60, 80).l(), 1) << c;
}

TEST(EvenLight, DarkStoneDoesNotBendTheSurface) {
  Raster<Lab> picture = lit(true);
  EXPECT_NEAR(specimen::even_light(picture), 2, 0.15);
  for (int c = 0; c < 160; ++c) EXPECT_NEAR(picture(30, c).l(), picture(30, 20).l(), 1.5) << c;
  EXPECT_NEAR(picture(100, 90).l(), picture(100, 150).l(), 1.5);
}

TEST(EvenLight, EvenPictureStaysAndTheSmallestOnesDoNoHarm) {
  Raster<Lab> picture(50, 50, Lab{90, 140, 120});
  EXPECT_NEAR(specimen::even_light(picture), 1, 1e-6);
  EXPECT_EQ(picture(20, 20).l_code, 90);
  EXPECT_EQ(picture(20, 20).a_code, 140);
  Raster<Lab> dot(1, 1, Lab{90, 128, 128});
  EXPECT_NEAR(specimen::even_light(dot), 1, 1e-6);
}

}  // namespace even_light_test
