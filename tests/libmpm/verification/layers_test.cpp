// Layered strips of moduli 1 and 2 with nu = 0 on moving points: across the layers the moduli add in series
// (Reuss), along them in parallel (Voigt).
#include <gtest/gtest.h>

#include "tests/libmpm/verification/static_plate.hpp"

namespace {

// The interfaces lie on edges of cells, where linear and GIMP points do not reach over them: what remains is
// what the slow loading leaves of waves, and with B-splines the smoothing over the interface, which falls
// with the cell.
TEST(Layers, GiveReussAcrossAndVoigtAlong) {
  for (const auto shape : samples::all_shapes()) {
    for (const int pixels : {16, 32}) {
      for (const bool along : {false, true}) {
        mpm::Scene scene = samples::plate(pixels);
        scene.kinematics = mpm::Kinematics::moving;
        scene.motion.shape = shape;
        scene.phases[1]->poisson = scene.phases[2]->poisson = 0;
        if (along)
          scene.labels.leftCols(pixels / 2).setConstant(2);
        else
          scene.labels.topRows(pixels / 2).setConstant(2);
        const double exact = along ? 1.5e7 : 1 / (0.5 / 1e7 + 0.5 / 2e7);
        const double error = samples::solve(scene).modulus / exact - 1;
        if (samples::figures)
          std::printf("shape %d, %d pixels, %s: %+.4f\n", static_cast<int>(shape), pixels,
                      along ? "Voigt" : "Reuss", error);
        EXPECT_NEAR(error, 0, pixels == 16 ? 8e-3 : 3e-3);
      }
    }
  }
}

}  // namespace
