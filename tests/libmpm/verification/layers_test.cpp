// Layered strips of moduli 1 and 2 with nu = 0 on moving points: across the layers the moduli add in series
// (Reuss), along them in parallel (Voigt).
#include <gtest/gtest.h>

#include "libmpm/problems/plate.hpp"
#include "tests/libmpm/moving_scenes.hpp"

namespace layers_test {

using mpm::problems::Layers;

// The interfaces lie on edges of cells, where linear and GIMP points do not reach over them: what remains is
// what the slow loading leaves of waves, and with B-splines the smoothing over the interface, which falls
// with the cell.
TEST(Layers, GiveReussAcrossAndVoigtAlong) {
  for (const auto shape : samples::all_shapes()) {
    for (const int pixels : {16, 32}) {
      for (const auto layers : {Layers::across, Layers::along}) {
        mpm::Scene scene = mpm::problems::layered_plate(pixels, layers);
        scene.kinematics = mpm::Kinematics::moving;
        scene.motion.shape = shape;
        const double error = mpm::problems::pull(scene).modulus / mpm::problems::layered_modulus(layers) - 1;
        if (samples::figures)
          std::printf("shape %d, %d pixels, %s: %+.4f\n", static_cast<int>(shape), pixels,
                      layers == Layers::along ? "Voigt" : "Reuss", error);
        EXPECT_NEAR(error, 0, pixels == 16 ? 8e-3 : 3e-3);
      }
    }
  }
}

TEST(Layers, GiveTheSameOnTheLattice) {
  for (const auto layers : {Layers::across, Layers::along})
    EXPECT_NEAR(mpm::problems::pull(mpm::problems::layered_plate(32, layers)).modulus /
                    mpm::problems::layered_modulus(layers),
                1, 5e-3);
}

TEST(Layers, BearTheLongestStepDampedOrNot) {
  mpm::Scene scene = mpm::problems::layered_plate(64, Layers::across);
  scene.cfl = 0.99;
  EXPECT_EQ(mpm::problems::pull(scene).trouble, "");
  scene.local_damping = 0.95;  // which shortens the step
  EXPECT_EQ(mpm::problems::pull(scene).trouble, "");
}

}  // namespace layers_test
