#include "specimen/body/ellipse.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace specimen {
namespace inclusion_test {

constexpr double pi = std::numbers::pi;

TEST(Inclusion, OfAnEllipseIsExact) {
  const Ellipse ellipse{0.1, 0.2, 2, 1, pi + 0.25};
  const Inclusion inclusion = make_inclusion(7, ellipse);
  EXPECT_EQ(inclusion.id, 7);
  EXPECT_EQ(inclusion.ellipse, ellipse);
  EXPECT_TRUE(inclusion.contour.empty());
  EXPECT_DOUBLE_EQ(inclusion.area, 2 * pi);
  EXPECT_DOUBLE_EQ(inclusion.perimeter, 9.688448220547675);
  EXPECT_DOUBLE_EQ(pi / 4 * inclusion.equivalent_diameter * inclusion.equivalent_diameter, 2 * pi);
  EXPECT_NEAR(inclusion.orientation, 0.25, 1e-15);
}

TEST(Inclusion, OrientationLiesInHalfATurn) {
  for (const double angle : {-7.0, -pi, -1e-20, 0.0, 3.0, pi, 100.0}) {
    const double orientation = make_inclusion(1, {0, 0, 2, 1, angle}).orientation;
    EXPECT_GE(orientation, 0) << angle;
    EXPECT_LT(orientation, pi) << angle;
  }
}

}  // namespace inclusion_test
}  // namespace specimen
