#include "libmpm/material/failure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softening_test {

using mpm::Plane;

mpm::Phase soft_mortar() {
  mpm::Phase phase = mpm::concrete_phases()[1];
  phase.fracture_energy = 60;
  return phase;
}

// Area under the stress-strain curve of a bar, times the width of the band.
TEST(Softening, DissipatesTheFractureEnergyInABandOfAnyWidth) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    for (const double band : {0.25e-3, 1e-3, 4e-3}) {
      const mpm::Softening curve = mpm::softening(soft_mortar(), plane, 6e6, band);
      double area = 0.5 * curve.peak * curve.onset;
      const int n = 40000;
      const double step = 20 * curve.scale / n;
      for (int i = 0; i < n; ++i) area += step * curve.stress_at(curve.onset + (i + 0.5) * step);
      EXPECT_NEAR(area * band, 60, 1e-4 * 60);
    }
  }
}

TEST(Softening, BeginsAtTheStrainOfABarThatIsFreeSideways) {
  EXPECT_DOUBLE_EQ(mpm::softening(soft_mortar(), Plane::strain, 6e6, 1e-3).onset, 6e6 * (1 - 0.04) / 20e9);
  EXPECT_DOUBLE_EQ(mpm::softening(soft_mortar(), Plane::stress, 6e6, 1e-3).onset, 6e6 / 20e9);
  EXPECT_EQ(mpm::softening(soft_mortar(), Plane::stress, 6e6, 1e-3).stress_at(1e-4), 6e6);
}

TEST(Softening, SnapsBackBeyondTheWidestBand) {
  const double widest = mpm::widest_band(soft_mortar(), Plane::stress, 6e6);
  EXPECT_DOUBLE_EQ(widest, 2 * 20e9 * 60 / 36e12);
  EXPECT_GT(mpm::softening(soft_mortar(), Plane::stress, 6e6, 0.99 * widest).scale, 0);
  EXPECT_LT(mpm::softening(soft_mortar(), Plane::stress, 6e6, 1.01 * widest).scale, 0);
}

TEST(LargestStrain, InvertsTheStiffness) {
  const mpm::Phase phase = soft_mortar();
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Eigen::Vector3d strain(3e-4, -1e-4, 2e-4);
    const Eigen::Vector3d s = mpm::stiffness(phase, plane) * strain;
    const double first = 1e-4 + std::hypot(2e-4, 1e-4);
    EXPECT_NEAR(mpm::largest_strain(phase, plane, {s(0), s(1), s(2)}), first, 1e-12);
  }
}

}  // namespace softening_test
