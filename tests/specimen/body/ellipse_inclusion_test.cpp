#include "specimen/body/ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace ellipse_inclusion_test {

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

TEST(Rotation, AgreesWithTheLibrary) {
  Random random(1);
  for (int n = 0; n < 100'000; ++n) {
    const double angle = random.uniform(-6.28, 6.28);
    const Rotation r = rotation_by(angle);
    ASSERT_NEAR(r.cos, std::cos(angle), 4e-16) << angle;
    ASSERT_NEAR(r.sin, std::sin(angle), 4e-16) << angle;
    ASSERT_NEAR(r.cos * r.cos + r.sin * r.sin, 1, 5e-16) << angle;
  }
}

// Farther out 2 pi itself is rounded, as the angle is.
TEST(Rotation, TakesAnyNumberOfTurns) {
  for (const double angle : {1e2, -1e4, 1e6}) {
    EXPECT_NEAR(rotation_by(angle).cos, std::cos(angle), 1e-16 * std::abs(angle)) << angle;
    EXPECT_NEAR(rotation_by(angle).sin, std::sin(angle), 1e-16 * std::abs(angle)) << angle;
  }
}

TEST(Rotation, IsExactAtNought) {
  EXPECT_EQ(rotation_by(0).cos, 1);
  EXPECT_EQ(rotation_by(0).sin, 0);
}

TEST(Rotation, KeepsItsSignsInAllQuadrants) {
  for (int quadrant = -9; quadrant < 9; ++quadrant) {
    const double angle = (quadrant + 0.3) * std::numbers::pi / 2;
    EXPECT_NEAR(rotation_by(angle).cos, std::cos(angle), 1e-15) << quadrant;
    EXPECT_NEAR(rotation_by(angle).sin, std::sin(angle), 1e-15) << quadrant;
  }
}

}  // namespace ellipse_inclusion_test
}  // namespace specimen
