// A disc drawn as pixels in a plate under tension. Inside of it the stress is uniform:
//   mean     p = (T / 2) m2 (k1 + 1) / (2 m2 + m1 (k2 - 1)),
//   deviator s = (T / 2) m2 (k1 + 1) / (m1 + k1 m2),   k = 3 - 4 nu in plane strain.
// Source: Goodier, Trans. ASME 55 (1933); written as in Mura, Micromechanics of defects in solids, ch. 4.
//
// The plate is five discs wide. What the disc does to the stress falls with (a / r)^2 and is 0.2 T at its
// edge for a modulus ratio of 2, hence 0.2 / 5^2, about 1 % of T at the edges of the plate: no error below
// that can be told from the plate's size.
#include <gtest/gtest.h>

#include "tests/libmpm/verification/static_plate.hpp"

namespace {

struct Errors {
  double mean = 0;   ///< of s_yy over the disc
  double inner = 0;  ///< root of the mean square over the points within half its radius
};
Errors errors(int pixels, mpm::Kinematics kinematics, mpm::Shape shape = mpm::Shape::gimp) {
  mpm::Scene scene = samples::plate(pixels);
  samples::draw_disc(scene, 0.1, 2);
  scene.local_damping = 0.3;
  scene.kinematics = kinematics;
  scene.motion.shape = shape;
  const double m = 2, k = 3 - 4 * 0.2;
  const double p = 0.5 * m * (k + 1) / (2 * m + (k - 1));
  const double s = 0.5 * m * (k + 1) / (1 + k * m);
  Errors e;
  int all = 0, inner = 0;
  for (const auto& point : samples::solve(scene).points) {
    if (point.label != 2) continue;
    ++all;
    e.mean += point.stress.yy - (p + s);
    if (std::hypot(point.x, point.y) > 0.05) continue;
    ++inner;
    e.inner += std::pow(point.stress.yy - (p + s), 2) + std::pow(point.stress.xx - (p - s), 2) +
               2 * std::pow(point.stress.xy, 2);
  }
  e = {e.mean / all, std::sqrt(e.inner / inner)};
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

}  // namespace
