// A round hole drawn as pixels in a plate under tension: across the plate beside the hole
// s_yy(x, 0) = (T / 2) (2 + (a / x)^2 + 3 (a / x)^4), three times T at its edge. Source: Kirsch (1898).
// The plate is five holes wide; its gross stress concentration is then 3.14 and not 3 (Peterson's diagram).
#include <gtest/gtest.h>

#include "tests/libmpm/verification/static_plate.hpp"

namespace {

TEST(Hole, Figures) {
  for (const bool moving : {false, true}) {
    for (const int pixels : {40, 80}) {
      mpm::Scene scene = samples::plate(pixels);
      samples::draw_disc(scene, 0.1, 0);
      if (moving) scene.kinematics = mpm::Kinematics::moving;
      for (const auto& p : samples::solve(scene).points) {
        if (p.x < 0 || p.x > 0.3 || p.y < 0 || p.y > scene.pixel_size) continue;
        const double q = 0.1 / p.x;
        std::printf("%s %d x/a %.3f  %.3f  Kirsch %.3f\n", moving ? "moving" : "lattice", pixels, 1 / q,
                    p.stress.yy, 0.5 * (2 + q * q + 3 * q * q * q * q));
      }
    }
  }
}

}  // namespace
