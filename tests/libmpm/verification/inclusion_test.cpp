// A disc drawn as pixels in a plate under tension carries the uniform stress of Goodier's solution.
//
// The plate is five discs wide. What the disc does to the stress falls with (a / r)^2 and is 0.2 T at its
// edge for a modulus ratio of 2, hence 0.2 / 5^2, about 1 % of T at the edges of the plate: no error below
// that can be told from the plate's size.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/problems/plate.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/verification/order.hpp"

namespace inclusion_test {

using Errors = mpm::problems::InclusionErrors;

Errors errors(int pixels, mpm::Kinematics kinematics, mpm::Shape shape = mpm::Shape::gimp) {
  mpm::Scene scene = mpm::problems::plate(pixels);
  mpm::problems::draw_disc(scene, 0.1, 2);
  scene.local_damping = 0.3;
  scene.kinematics = kinematics;
  scene.motion.shape = shape;
  const auto plate = mpm::problems::pull(scene);
  EXPECT_EQ(plate.trouble, "");
  const Errors e = mpm::problems::inclusion_errors(plate, 0.1);
  if (samples::figures)
    std::printf(
        "inclusion, %d pixels, %s: mean %+.4f inner %.4f\n", pixels,
        kinematics == mpm::Kinematics::moving ? (shape == mpm::Shape::gimp ? "GIMP" : "B-spline") : "lattice",
        e.mean, e.inner);
  return e;
}

// The stair-shaped boundary disturbs the points beside it, whatever the pixel; its share of the disc, and so
// the error of the mean, falls with the pixel, and within half the radius little of it is left.
TEST(Inclusion, OfPixelsCarriesGoodiersStress) {
  const Errors coarse = errors(40, mpm::Kinematics::small_strain);
  const Errors fine = errors(80, mpm::Kinematics::small_strain);
  EXPECT_LT(coarse.inner, 0.025);
  EXPECT_LT(fine.inner, 0.015);
  EXPECT_LT(std::abs(coarse.mean), 0.05);
  EXPECT_LT(std::abs(fine.mean), 0.8 * std::abs(coarse.mean));
}
TEST(Inclusion, CarriesTheSameOnMovingPoints) {
  for (const auto shape : {mpm::Shape::gimp, mpm::Shape::bspline}) {
    const Errors e = errors(40, mpm::Kinematics::moving, shape);
    EXPECT_LT(e.inner, shape == mpm::Shape::bspline ? 0.05 : 0.03)
        << "B-splines smooth over half of a disc of four cells";
    EXPECT_LT(std::abs(e.mean), 0.05);
  }
}

// Without waves and in a plate forty discs' radii wide the stair is all that is left, and what it does inside
// the disc falls with the pixel.
TEST(Inclusion, OfPixelCellsConvergesWithThePixel) {
  const auto error = [](int pixels) {
    mpm::Scene scene = mpm::problems::plate(pixels);
    mpm::problems::draw_disc(scene, 0.025, 2);
    scene.pixel_cells = true;
    scene.points_per_cell = 1;
    scene.method = mpm::SolverMethod::quasi_static;
    const auto plate = mpm::problems::pull(scene);
    EXPECT_EQ(plate.trouble, "");
    return mpm::problems::inclusion_errors(plate, 0.025);
  };
  std::vector<double> sizes, mean, inner;
  for (const int pixels : {80, 160, 320}) {
    const Errors errors = error(pixels);
    sizes.push_back(1.0 / pixels);
    mean.push_back(errors.mean);
    inner.push_back(errors.inner);
  }
  EXPECT_GE(samples::fitted_order(sizes, inner), 1);
  EXPECT_GE(samples::fitted_order(sizes, mean), 0.95);
}

}  // namespace inclusion_test
