#include "specimen/body/ellipse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen/body/raster.hpp"

namespace specimen {
namespace rotation_test {

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

}  // namespace rotation_test
}  // namespace specimen
