#include "specimen/pack/canvas.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "specimen/body/error.hpp"

namespace specimen {
namespace canvas_test {

std::string refusal(double width, double height, double pixel_size) {
  try {
    (void)canvas_of(width, height, pixel_size, "twin");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Canvas, HasWholePixels) {
  const Canvas canvas = canvas_of(0.15, 0.1, 0.5e-3, "twin");
  EXPECT_EQ(canvas.cols, 300);
  EXPECT_EQ(canvas.rows, 200);
}

TEST(Canvas, RefusesPartsOfAPixelByTheNameOfItsField) {
  EXPECT_EQ(refusal(0.1, 0.0503, 0.5e-3),
            "twin.height: 50.3 mm; must be a whole number of pixels of 0.5 mm; take 50 mm or 50.5 mm");
  EXPECT_EQ(refusal(0.2e-3, 0.1, 0.5e-3),
            "twin.width: 0.2 mm; must be a whole number of pixels of 0.5 mm; take 0.5 mm");
  EXPECT_EQ(refusal(0.1, 0.1, 0), "twin.pixel_size: 0 mm; must be > 0");
  EXPECT_EQ(refusal(std::numeric_limits<double>::quiet_NaN(), 0.1, 1e-3), "twin.width: nan mm; must be > 0");
}

TEST(Canvas, RefusesMorePixelsThanASpecimenMayHave) {
  EXPECT_EQ(refusal(20, 20, 1e-3),
            "twin.pixel_size: 1 mm; makes 20000 x 20000 pixels; at most 2e+08 are allowed; raise the pixel "
            "size");
}

}  // namespace canvas_test
}  // namespace specimen
