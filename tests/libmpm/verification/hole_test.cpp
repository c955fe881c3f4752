// A round hole drawn as pixels in a plate under tension: across the plate beside the hole
// s_yy(x, 0) = (T / 2) (2 + (a / x)^2 + 3 (a / x)^4), three times T at its edge. Source: Kirsch (1898).
// The plate is five holes wide; its gross stress concentration is then 3.14 and not 3 (Peterson's diagram).
#include <gtest/gtest.h>

#include "tests/libmpm/verification/static_plate.hpp"

namespace {

// Within a pixel of the edge the stair shows; elsewhere the plate's width adds up to 0.07 T.
void expect_kirsch(const mpm::Scene& drawn) {
  mpm::Scene scene = drawn;
  samples::draw_disc(scene, 0.1, 0);
  int points = 0;
  double highest = 0;
  for (const auto& p : samples::solve(scene).points) {
    if (p.x < 0 || p.x > 0.3 || p.y < 0 || p.y > scene.pixel_size) continue;
    const double q = 0.1 / p.x;
    const double kirsch = 0.5 * (2 + q * q + 3 * q * q * q * q);
    const bool edge = p.x < 0.1 + scene.pixel_size;
    if (samples::figures) std::printf("x/a %.3f: %.3f, Kirsch %.3f\n", 1 / q, p.stress.yy, kirsch);
    const double tolerance = edge ? 0.1 * kirsch : 0.07;
    EXPECT_NEAR(p.stress.yy, edge ? kirsch : kirsch + 0.035, tolerance) << "at x/a = " << 1 / q;
    highest = std::max(highest, p.stress.yy);
    ++points;
  }
  EXPECT_GT(points, 5);
  EXPECT_GT(highest, 2.2);
}
TEST(Hole, OfPixelsConcentratesStressAsKirschSays) {
  expect_kirsch(samples::plate(40));
  expect_kirsch(samples::plate(80));
}
TEST(Hole, ConcentratesTheSameOnMovingPoints) {
  mpm::Scene scene = samples::plate(40);
  scene.kinematics = mpm::Kinematics::moving;
  expect_kirsch(scene);
}

}  // namespace
