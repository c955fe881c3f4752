// A strip with a weak row of pixels, pulled apart: the crack must cost its fracture energy times its length,
// whatever the size of the pixels, and however the points follow the motion.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "libmpm/material/strength.hpp"
#include "libmpm/run/simulate.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace crack_band_test {

constexpr double width = 4e-3;
constexpr double height = 8e-3;
constexpr double fracture_energy = 60;

/// All points have the strength of their phase to 1e-8; those of the weak row are weaker by a twentieth.
mpm::Scene strip(double pixel_size, double poisson) {
  const auto rows = static_cast<int>(height / pixel_size + 0.5);
  const auto cols = static_cast<int>(width / pixel_size + 0.5);
  mpm::Scene scene = samples::mortar_block(rows, cols, pixel_size);
  scene.labels.row(rows / 2 - 1).setConstant(samples::itz);
  *scene.phases[samples::itz] = *scene.phases[samples::mortar];
  for (const auto label : {samples::mortar, samples::itz}) {
    mpm::Phase& phase = *scene.phases[label];
    phase.poisson = poisson;
    phase.tensile_scale = label == samples::itz ? 5.7e6 : 6e6;
    phase.cohesion = mpm::Phase::unbreakable;
    phase.weibull_modulus = 1e9;
    phase.fracture_energy = fracture_energy;
  }
  scene.phases[samples::aggregate]->poisson = poisson;
  scene.loading.velocity = 0.06;
  scene.loading.stop_strain = 9 * fracture_energy / 5.7e6 / height;
  scene.local_damping = 0.2;
  scene.history_rows = 100;
  return scene;
}

/// Energy that the crack took over that of its length.
double dissipation(const mpm::Scene& scene, const char* name) {
  const mpm::Result result = mpm::simulate(scene);
  const double ratio = result.history.back().released / (fracture_energy * width);
  if (samples::figures)
    std::printf("%s, pixel %.3f mm, nu %.1f: %.4f of G_f, peak %.3f MPa, imbalance %.1e\n", name,
                1e3 * scene.pixel_size, scene.phases[samples::mortar]->poisson, ratio,
                1e-6 * result.peak_stress, result.energy_error);
  EXPECT_NEAR(result.peak_stress, 5.7e6, 0.06 * 5.7e6);
  EXPECT_LT(result.energy_error, 0.02);
  return ratio;
}

// With 2 x 2 points a cell the band is the cell: its strain is one, and both rows of its points crack.
TEST(CrackBand, CostsItsFractureEnergyForEveryPixelSizeInSmallStrain) {
  for (const double pixel : {1e-3, 0.5e-3, 0.25e-3})
    for (const double poisson : {0.0, 0.2})
      EXPECT_NEAR(dissipation(strip(pixel, poisson), "small strain"), 1, 0.02);
}

TEST(CrackBand, CostsItsFractureEnergyByEveryCurve) {
  for (const auto curve : {mpm::SofteningCurve::bilinear, mpm::SofteningCurve::hordijk})
    for (const auto kinematics : {mpm::Kinematics::small_strain, mpm::Kinematics::moving}) {
      mpm::Scene scene = strip(0.5e-3, 0.2);
      for (auto& phase : scene.phases)
        if (phase && phase->fracture_energy > 0) phase->softening = curve;
      scene.kinematics = kinematics;
      EXPECT_NEAR(dissipation(scene, "another curve"), 1, 0.02);
    }
}

// The error of the ledger comes from cracks that close within a step, and falls with its square. What is
// stored of a point is rounded to 32 bits: a loss per step, however small, would grow as the steps become
// shorter.
TEST(CrackBand, ThatClosesLosesLessEnergyInShorterSteps) {
  std::vector<double> errors;
  for (const double cfl : {0.8, 0.2}) {
    mpm::Scene scene = samples::small_concrete(24, 24);
    for (const auto label : {samples::mortar, samples::itz}) {
      mpm::Phase& phase = *scene.phases[label];
      phase.tensile_scale = label == samples::itz ? 2.5e6 : 4e6;
      phase.weibull_modulus = 4;
      phase.fracture_energy = 20;
    }
    scene.loading.velocity = 0.1;
    scene.loading.stop_strain = 6e-4;
    scene.damage.crack_closure = mpm::CrackClosure::unilateral;
    scene.cfl = cfl;
    errors.push_back(mpm::simulate(scene).energy_error);
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_LT(errors[1], 0.3 * errors[0]);
}

TEST(CrackBand, CostsItsFractureEnergyForEveryPixelSizeWhenPointsMove) {
  for (const auto shape : samples::all_shapes()) {
    for (const double pixel : {1e-3, 0.5e-3, 0.25e-3}) {
      mpm::Scene scene = strip(pixel, 0.2);
      scene.kinematics = mpm::Kinematics::moving;
      scene.motion.shape = shape;
      const char* names[] = {"linear", "GIMP", "B-spline"};
      EXPECT_NEAR(dissipation(scene, names[static_cast<int>(shape)]), 1, 0.02);
    }
  }
}

// The points go over to moving while the crack is half open, and the rest of it costs the rest.
TEST(CrackBand, CostsItsFractureEnergyWhenPointsBeginToMoveHalfWay) {
  for (const auto closure : {mpm::CrackClosure::off, mpm::CrackClosure::unilateral}) {
    mpm::Scene scene = strip(0.5e-3, 0.2);
    scene.kinematics = mpm::Kinematics::automatic;
    scene.handover.displacement = 3e-3;
    scene.damage.crack_closure = closure;
    const mpm::Result result = mpm::simulate(scene);
    EXPECT_NEAR(result.history.back().released, fracture_energy * width, 0.02 * fracture_energy * width);
    double before = 0;
    for (const mpm::HistoryRow& row : result.history)
      if (row.moving_points == 0) before = row.released / (fracture_energy * width);
    EXPECT_GT(before, 0.2);
    EXPECT_LT(before, 0.8);
  }
}

// A weak row of pixels is pressed together and slips: it costs its energy in shear.
TEST(CrackBand, CostsItsEnergyInShear) {
  constexpr double energy = 200;
  for (const double pixel : {1e-3, 0.5e-3}) {
    for (const bool pixel_cells : {true, false}) {
      mpm::Scene scene = strip(pixel, 0);
      for (const auto label : {samples::mortar, samples::itz}) {
        mpm::Phase& phase = *scene.phases[label];
        phase.tensile_scale = mpm::Phase::unbreakable;
        phase.fracture_energy = 0;
        phase.cohesion = label == samples::itz ? 4e6 : 8e6;
        phase.friction_angle = 0.5;
        phase.shear_fracture_energy = energy;
      }
      scene.pixel_cells = pixel_cells;
      scene.points_per_cell = pixel_cells ? 1 : 2;
      scene.damage.crack_closure = mpm::CrackClosure::unilateral;
      scene.loading.direction = mpm::Direction::compression;
      scene.loading.stop_strain = 9 * energy / 13e6 / height;
      scene.loading.velocity = 0.1;
      const mpm::Result result = mpm::simulate(scene);
      EXPECT_NEAR(result.history.back().released, energy * width, 0.02 * energy * width) << pixel;
      const double strength = mpm::compressive_strength(*scene.phases[samples::itz], 1);
      if (pixel_cells) {
        EXPECT_NEAR(result.peak_stress, strength, 0.04 * strength) << pixel;
      }
      EXPECT_LT(result.energy_error, 0.01);
    }
  }
}

}  // namespace crack_band_test
