#include "libmpm/material/stiffness_bounds.hpp"

#include <gtest/gtest.h>

namespace stiffness_bounds_test {

using mpm::PhaseShare;
using mpm::Plane;
using mpm::PlaneModuli;

mpm::Phase phase(double young, double poisson) {
  return {.name = "phase", .young = young, .poisson = poisson, .density = 2400};
}

TEST(StiffnessBounds, ModuliAndTensorOfAPhaseAreTheSame) {
  for (const Plane plane : {Plane::strain, Plane::stress})
    for (const double poisson : {0.0, 0.2, 0.45}) {
      const mpm::Phase one = phase(30e9, poisson);
      const PlaneModuli moduli = plane_moduli(one, plane);
      EXPECT_LT((stiffness(moduli) - stiffness(one, plane)).norm(), 1e-3);
      const mpm::ElasticConstants back = elastic_constants(moduli, plane);
      EXPECT_NEAR(back.young, 30e9, 1);
      EXPECT_NEAR(back.poisson, poisson, 1e-12);
      const mpm::NearestIsotropic nearest = mpm::nearest_isotropic(stiffness(one, plane));
      EXPECT_NEAR(nearest.moduli.bulk, moduli.bulk, 1);
      EXPECT_NEAR(nearest.moduli.shear, moduli.shear, 1);
      EXPECT_LT(nearest.distance, 1e-12);
    }
}

TEST(StiffnessBounds, TheNearestIsotropicTensorIsNearerThanItsNeighbours) {
  Eigen::Matrix3d c;
  c << 30, 5, 2, 5, 20, -1, 2, -1, 9;
  const auto distance = [&](const PlaneModuli& moduli) {
    const Eigen::Matrix3d d = c - stiffness(moduli);
    // Of the 16 components C_ijkl: those with one shear pair count twice, those with two four times.
    return d.topLeftCorner<2, 2>().squaredNorm() + 4 * d.topRightCorner<2, 1>().squaredNorm() +
           4 * d(2, 2) * d(2, 2);
  };
  const mpm::NearestIsotropic found = mpm::nearest_isotropic(c);
  const double least = distance(found.moduli);
  for (const double bulk : {-0.1, 0.0, 0.1})
    for (const double shear : {-0.1, 0.1})
      EXPECT_GT(distance({found.moduli.bulk + bulk, found.moduli.shear + shear}), least);
  EXPECT_NEAR(found.distance, std::sqrt(least / distance({})), 1e-12);
  // A turned picture is as far from it, and near the same.
  Eigen::Matrix3d turned;  // by 45 degrees, engineering shear
  turned << 0.5, 0.5, 0.5, 0.5, 0.5, -0.5, -1, 1, 0;
  const mpm::NearestIsotropic again = mpm::nearest_isotropic(turned.transpose() * c * turned);
  EXPECT_NEAR(again.distance, found.distance, 1e-12);
  EXPECT_NEAR(again.moduli.bulk, found.moduli.bulk, 1e-12);
  EXPECT_NEAR(again.moduli.shear, found.moduli.shear, 1e-12);
}

/// Hashin and Shtrikman's bounds of two phases as they are usually written.
double two_phase_bulk(double k1, double g1, double k2, double share2) {
  return k1 + share2 / (1 / (k2 - k1) + (1 - share2) / (k1 + g1));
}
double two_phase_shear(double k1, double g1, double g2, double share2) {
  return g1 + share2 / (1 / (g2 - g1) + (1 - share2) * (k1 + 2 * g1) / (2 * g1 * (k1 + g1)));
}

TEST(StiffnessBounds, TwoPhasesHaveTheKnownOnes) {
  const PlaneModuli soft{10, 6};
  const PlaneModuli hard{50, 20};
  const mpm::StiffnessBounds bounds = mpm::stiffness_bounds({{0.7, soft}, {0.3, hard}});
  EXPECT_NEAR(bounds.voigt.bulk, 22, 1e-12);
  EXPECT_NEAR(bounds.reuss.shear, 1 / (0.7 / 6 + 0.3 / 20), 1e-12);
  EXPECT_NEAR(bounds.hashin_shtrikman_lower.bulk, two_phase_bulk(10, 6, 50, 0.3), 1e-12);
  EXPECT_NEAR(bounds.hashin_shtrikman_upper.bulk, two_phase_bulk(50, 20, 10, 0.7), 1e-12);
  EXPECT_NEAR(bounds.hashin_shtrikman_lower.shear, two_phase_shear(10, 6, 20, 0.3), 1e-12);
  EXPECT_NEAR(bounds.hashin_shtrikman_upper.shear, two_phase_shear(50, 20, 6, 0.7), 1e-12);
}

TEST(StiffnessBounds, TheyStandInOrder) {
  const mpm::StiffnessBounds b =
      mpm::stiffness_bounds({{0.2, {10, 6}}, {0.5, {50, 20}}, {0.3, {30, 25}}});  // no order of both moduli
  for (const auto modulus : {&PlaneModuli::bulk, &PlaneModuli::shear}) {
    EXPECT_LT(b.reuss.*modulus, b.hashin_shtrikman_lower.*modulus);
    EXPECT_LT(b.hashin_shtrikman_lower.*modulus, b.hashin_shtrikman_upper.*modulus);
    EXPECT_LT(b.hashin_shtrikman_upper.*modulus, b.voigt.*modulus);
  }
}

TEST(StiffnessBounds, VoidMakesTheLowerOnesZero) {
  const mpm::StiffnessBounds bounds = mpm::stiffness_bounds({{0.1, {}}, {0.9, {10, 6}}});
  for (const PlaneModuli& zero : {bounds.reuss, bounds.hashin_shtrikman_lower}) {
    EXPECT_EQ(zero.bulk, 0);
    EXPECT_EQ(zero.shear, 0);
    EXPECT_EQ(elastic_constants(zero, Plane::strain).young, 0);
  }
  EXPECT_NEAR(bounds.hashin_shtrikman_upper.bulk, two_phase_bulk(10, 6, 0, 0.1), 1e-12);
  EXPECT_NEAR(bounds.voigt.shear, 5.4, 1e-12);
}

TEST(StiffnessBounds, SharesAreThoseOfThePixels) {
  mpm::Scene scene;
  scene.labels = mpm::PixelField<std::uint8_t>::Constant(4, 5, 2);
  scene.labels.topRows(1).setConstant(0);
  scene.phases = {std::nullopt, phase(10e9, 0.2), phase(20e9, 0.2)};
  const std::vector<PhaseShare> shares = phase_shares(scene);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0].share, 0.25);
  EXPECT_EQ(shares[0].moduli.bulk, 0);
  EXPECT_EQ(shares[1].moduli.shear, 20e9 / 2.4);
}

}  // namespace stiffness_bounds_test
