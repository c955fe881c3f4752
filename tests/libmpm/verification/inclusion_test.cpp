// A disc drawn as pixels in a plate under tension. Inside of it the stress is uniform:
//   mean     p = (T / 2) m2 (k1 + 1) / (2 m2 + m1 (k2 - 1)),
//   deviator s = (T / 2) m2 (k1 + 1) / (m1 + k1 m2),   k = 3 - 4 nu in plane strain.
// Source: Goodier, Trans. ASME 55 (1933); written as in Mura, Micromechanics of defects in solids, ch. 4.
//
// The plate is five discs wide. What the disc does to the stress falls with (a / r)^2 and is 0.2 T at its edge
// for a modulus ratio of 2, hence 0.2 / 5^2, about 1 % of T at the edges of the plate: no error below that
// can be told from the plate's size.
#include <gtest/gtest.h>

#include "tests/libmpm/verification/order.hpp"
#include "tests/libmpm/verification/static_plate.hpp"

namespace {

struct Errors {
  double mean_yy = 0, mean_xx = 0;  ///< of the mean stress in the disc over T
  double rms = 0;                   ///< root of the mean square over the points of the disc
};
Errors errors(int pixels, mpm::Kinematics kinematics, mpm::Shape shape = mpm::Shape::gimp) {
  mpm::Scene scene = samples::plate(pixels);
  samples::draw_disc(scene, 0.1, 2);
  scene.kinematics = kinematics;
  scene.motion.shape = shape;
  const double m = 2, k = 3 - 4 * 0.2;
  const double p = 0.5 * m * (k + 1) / (2 * m + (k - 1));
  const double s = 0.5 * m * (k + 1) / (1 + k * m);
  Errors e;
  int count = 0;
  for (const auto& point : samples::solve(scene).points) {
    if (point.label != 2) continue;
    ++count;
    e.mean_yy += point.stress.yy - (p + s);
    e.mean_xx += point.stress.xx - (p - s);
    e.rms += std::pow(point.stress.yy - (p + s), 2) + std::pow(point.stress.xx - (p - s), 2) +
             2 * std::pow(point.stress.xy, 2);
  }
  return {e.mean_yy / count, e.mean_xx / count, std::sqrt(e.rms / count)};
}

TEST(Inclusion, Figures) {
  for (const int pixels : {40, 80, 120}) {
    const Errors e = errors(pixels, mpm::Kinematics::small_strain);
    std::printf("lattice %3d: mean yy %+.4f xx %+.4f rms %.4f\n", pixels, e.mean_yy, e.mean_xx, e.rms);
  }
  for (const auto shape : samples::all_shapes())
    for (const int pixels : {40, 80}) {
      const Errors e = errors(pixels, mpm::Kinematics::moving, shape);
      std::printf("moving %d %3d: mean yy %+.4f xx %+.4f rms %.4f\n", static_cast<int>(shape), pixels, e.mean_yy,
                  e.mean_xx, e.rms);
    }
}

}  // namespace
