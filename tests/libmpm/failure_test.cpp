#include "libmpm/failure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using mpm::CrackClosure;
using mpm::FailureMode;
using mpm::Phase;
using mpm::Plane;
using mpm::PointState;
using mpm::Stress;

const Phase mortar = mpm::concrete_phases()[1];

TEST(WithoutTension, LeavesCompressionAlone) {
  const Stress<double> s = mpm::without_tension(Stress<double>{-3, -5, 1}, 0.25);
  EXPECT_DOUBLE_EQ(s.xx, -3);
  EXPECT_DOUBLE_EQ(s.yy, -5);
  EXPECT_DOUBLE_EQ(s.xy, 1);
}

TEST(WithoutTension, HasNoPositivePrincipalStressAndKeepsDirections) {
  for (const auto& s : std::array<Stress<double>, 4>{{{5, -2, 1}, {5, 2, 1}, {1, -9, 3}, {0, 0, 4}}}) {
    for (const double lateral : {0.0, 0.25}) {
      const auto c = mpm::without_tension(s, lateral);
      const double mean = 0.5 * (c.xx + c.yy);
      const double radius = std::hypot(0.5 * (c.xx - c.yy), c.xy);
      EXPECT_LE(mean + radius, 1e-12);
      EXPECT_NEAR(c.xy * (s.xx - s.yy), s.xy * (c.xx - c.yy), 1e-12);
    }
  }
}

TEST(WithoutTension, CompressionAlongAnOpenCrackIsUniaxial) {
  // Strain held open across the crack, compressed along it: the stress must be E' times the strain along it.
  const auto c = mpm::stiffness(mortar, Plane::strain);
  const double along = -1e-4;
  const Stress<double> elastic{c(0, 0) * 3e-4 + c(0, 1) * along, c(0, 1) * 3e-4 + c(0, 0) * along, 0};
  const auto s = mpm::carried_stress({&mortar, 1, CrackClosure::unilateral}, elastic, Plane::strain);
  EXPECT_NEAR(s.xx, 0, 1e-3);
  EXPECT_NEAR(s.yy, 20e9 / (1 - 0.04) * along, 1);
}

// Round a closed path of strains a law with a potential does no work; clipping alone does.
TEST(CrackClosure, UnilateralKeepsEnergyAndClippedDoesNot) {
  const auto c = mpm::stiffness(mortar, Plane::strain);
  const auto work = [&](CrackClosure law) {
    double sum = 0;
    double size = 0;
    constexpr int n = 20000;
    const auto strain = [](int i) {
      const double t = 2 * M_PI * i / n;
      return Eigen::Vector3d(2e-4 + 3e-4 * std::cos(t), -1e-4 + 3e-4 * std::sin(t), 1e-4 * std::sin(2 * t));
    };
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector3d e = 0.5 * (strain(i) + strain(i + 1));
      const Eigen::Vector3d de = strain(i + 1) - strain(i);
      const Eigen::Vector3d elastic = c * e;
      const auto s =
          mpm::carried_stress({&mortar, 1, law}, {elastic(0), elastic(1), elastic(2)}, Plane::strain);
      const double dw = s.xx * de(0) + s.yy * de(1) + s.xy * de(2);
      sum += dw;
      size += std::abs(dw);
    }
    return std::abs(sum) / size;
  };
  EXPECT_LT(work(CrackClosure::unilateral), 1e-6);
  EXPECT_GT(work(CrackClosure::clipped), 1e-2);
}

TEST(Judge, TestsTensionFirstAndACrackedPointForShearOnly) {
  const Stress<double> both{20e6, -900e6, 0};
  EXPECT_EQ(mpm::judge({&mortar, 1, CrackClosure::off}, both, Plane::strain), FailureMode::tension);
  EXPECT_EQ(mpm::judge({&mortar, 1, CrackClosure::unilateral}, both, Plane::strain), FailureMode::shear);
  EXPECT_EQ(mpm::judge({&mortar, 1, CrackClosure::clipped}, {20e6, 0, 0}, Plane::strain), FailureMode::none);
}

// Compressed alike from both sides: plane strain confines the third direction, in plane stress it is free.
TEST(Judge, TheStressOutOfThePlaneTakesPart) {
  const double phi = mortar.friction_angle;
  const double strength = 2 * mortar.cohesion * std::cos(phi) / (1 - std::sin(phi));
  const Stress<double> s{-1.01 * strength, -1.01 * strength, 0};
  EXPECT_EQ(mpm::judge({&mortar, 1, CrackClosure::off}, s, Plane::strain), FailureMode::none);
  EXPECT_EQ(mpm::judge({&mortar, 1, CrackClosure::off}, s, Plane::stress), FailureMode::shear);
}

TEST(StressPower, IsTwiceTheElasticEnergyDensity) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Eigen::Vector3d strain(1e-4, -3e-5, 2e-5);
    const Eigen::Vector3d s = mpm::stiffness(mortar, plane) * strain;
    const Stress<double> stress{s(0), s(1), s(2)};
    EXPECT_NEAR(mpm::stress_power(mortar, plane, stress, stress), strain.dot(s), 1e-9 * strain.dot(s));
  }
}

}  // namespace
