#include "apps/drawing/stress_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stress_component_test {

using output::phrase_of;
using output::stress_of;
using Component = output::StressComponent;

TEST(StressComponent, GivesBackTheComponents) {
  const mpm::FramePoint point{.sxx = 1, .syy = -2, .szz = 9, .sxy = 3};
  EXPECT_EQ(stress_of(point, Component::xx), 1);
  EXPECT_EQ(stress_of(point, Component::yy), -2);
  EXPECT_EQ(stress_of(point, Component::xy), 3);
}

TEST(StressComponent, PrincipalStressesDoNotTurnWithTheAxes) {
  for (const double angle : {0.0, 0.3, 1.1, 2.0}) {  // 7 and -4 along axes turned by it
    const double c = std::cos(angle), s = std::sin(angle);
    const mpm::FramePoint point{
        .sxx = 7 * c * c - 4 * s * s, .syy = 7 * s * s - 4 * c * c, .szz = 0.6, .sxy = 11 * s * c};
    EXPECT_NEAR(stress_of(point, Component::first), 7, 1e-12);
    EXPECT_NEAR(stress_of(point, Component::third), -4, 1e-12);
    EXPECT_NEAR(stress_of(point, Component::mises), std::sqrt((11 * 11 + 4.6 * 4.6 + 6.4 * 6.4) / 2), 1e-12);
  }
}

TEST(StressComponent, TheOneOutOfThePlaneIsAPrincipalStressToo) {
  EXPECT_EQ(stress_of({.sxx = -5, .syy = -6}, Component::first), 0) << "plane stress";
  EXPECT_EQ(stress_of({.sxx = 5, .syy = 6}, Component::third), 0);
}

/// Uniaxial: the stress; pure shear: sqrt(3) times it; the same on all sides: none.
TEST(StressComponent, VonMisesIsTheStressOfATensionTest) {
  EXPECT_DOUBLE_EQ(stress_of({.syy = -3}, Component::mises), 3);
  EXPECT_DOUBLE_EQ(stress_of({.sxy = 2}, Component::mises), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(stress_of({.sxx = 4, .syy = 4, .szz = 4}, Component::mises), 0);
}

TEST(StressComponent, IsNamedAfterTheLoadingWhereThereIsOne) {
  EXPECT_EQ(phrase_of(Component::yy, true), "stress in the direction of loading");
  EXPECT_EQ(phrase_of(Component::yy, false), "vertical stress");
  EXPECT_EQ(phrase_of(Component::xx, false), "horizontal stress");
  EXPECT_EQ(phrase_of(Component::first, true), "largest principal stress");
}

}  // namespace stress_component_test
