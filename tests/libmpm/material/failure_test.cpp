#include "libmpm/material/failure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "libmpm/material/softening.hpp"
#include "libmpm/material/strength.hpp"

namespace failure_test {

using mpm::CrackClosure;
using mpm::DamageLaw;
using mpm::FailureMode;
using mpm::Phase;
using mpm::Plane;
using mpm::PointState;
using mpm::Stress;

const Phase mortar = mpm::concrete_phases()[1];

/// A point that has failed in tension and carries compression.
PointState cracked_through() {
  PointState point = mpm::intact_point(mortar, 1);
  point.strength = Phase::unbreakable;
  point.cracked = 1;
  return point;
}

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
  const auto s = mpm::carried_stress(cracked_through(), elastic, {Plane::strain, CrackClosure::unilateral});
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
          mpm::carried_stress(cracked_through(), {elastic(0), elastic(1), elastic(2)}, {Plane::strain, law});
      const double dw = s.xx * de(0) + s.yy * de(1) + s.xy * de(2);
      sum += dw;
      size += std::abs(dw);
    }
    return std::abs(sum) / size;
  };
  EXPECT_LT(work(CrackClosure::unilateral), 1e-6);
  EXPECT_GT(work(CrackClosure::clipped), 1e-2);
}

TEST(Respond, TestsTensionFirstAndACrackedPointForShearOnly) {
  const Stress<double> both{20e6, -900e6, 0};
  const PointState intact = mpm::intact_point(mortar, 1);
  EXPECT_EQ(mpm::respond(intact, both, {}).failure, FailureMode::tension);
  const DamageLaw closing{Plane::strain, CrackClosure::unilateral};
  EXPECT_EQ(mpm::respond(cracked_through(), both, closing).failure, FailureMode::shear);
  EXPECT_FALSE(mpm::respond(cracked_through(), {20e6, 0, 0}, closing).changed);
}

// Compressed alike from both sides: plane strain confines the third direction, in plane stress it is free.
TEST(Respond, TheStressOutOfThePlaneTakesPart) {
  const double phi = mortar.friction_angle;
  const double strength = 2 * mortar.cohesion * std::cos(phi) / (1 - std::sin(phi));
  const Stress<double> s{-1.01 * strength, -1.01 * strength, 0};
  const PointState intact = mpm::intact_point(mortar, 1);
  EXPECT_EQ(mpm::respond(intact, s, {Plane::strain}).failure, FailureMode::none);
  EXPECT_EQ(mpm::respond(intact, s, {Plane::stress}).failure, FailureMode::shear);
}

TEST(Respond, APointThatFailsAtOneBlowKeepsItsResidualStiffness) {
  const PointState intact = mpm::intact_point(mortar, 1);
  const mpm::Response cracked = mpm::respond(intact, {16e6, 0, 0}, {.residual_stiffness = 0.1});
  EXPECT_TRUE(cracked.changed);
  EXPECT_EQ(cracked.point.kept, 0.1);
  EXPECT_TRUE(cracked.point.spent);
  EXPECT_FALSE(mpm::respond(cracked.point, {160e6, -1e9, 0}, {}).changed) << "nothing happens to it any more";
  EXPECT_FALSE(mpm::respond(intact, {14.9e6, 0, 0}, {}).changed);
  EXPECT_FALSE(mpm::respond(mpm::intact_point(mpm::concrete_phases()[0], 1), {1e12, 0, 0}, {}).changed);
}

TEST(Respond, ACrackThatClosesKeepsTheStiffnessUntilItIsCrushed) {
  const DamageLaw closing{.closure = CrackClosure::unilateral};
  const mpm::Response cracked = mpm::respond(mpm::intact_point(mortar, 1), {16e6, 0, 0}, closing);
  EXPECT_EQ(cracked.failure, FailureMode::tension);
  EXPECT_EQ(cracked.point.kept, 1);
  EXPECT_EQ(cracked.point.cracked, 1);
  const mpm::Response crushed = mpm::respond(cracked.point, {0, -1e9, 0}, closing);
  EXPECT_EQ(crushed.failure, FailureMode::shear);
  EXPECT_EQ(crushed.point.kept, 0);
  EXPECT_EQ(mpm::carried_stress(crushed.point, {0, -1e9, 0}, closing).yy, 0);
}

/// Pulled along y by strains that rise, fall and rise again, free sideways in the plane.
struct Pull {
  DamageLaw law;
  PointState point;
  double strain = 0;
  int failures = 0;

  double to(double end) {
    const double young = 20e9 / (1 - 0.04);
    const int n = 400;
    Stress<double> carried;
    for (int i = 1; i <= n; ++i) {
      const double e = strain + (end - strain) * i / n;
      const mpm::Response response = mpm::respond(point, {0, young * e, 0}, law);
      point = response.point;
      failures += response.failure == FailureMode::none ? 0 : 1;
      carried = mpm::carried_stress(point, {0, young * e, 0}, law);
    }
    strain = end;
    return carried.yy;
  }
};

Phase soft_mortar() {
  Phase phase = mortar;
  phase.tensile_scale = 6e6;
  phase.fracture_energy = 60;
  phase.cohesion = Phase::unbreakable;
  return phase;
}

// The answer is known in closed form: the curve of the softening while strain is new, a straight line to the
// origin and back while it is not.
// A point that stands at its curve, but for the rounding of its strength to 32 bits, stays as it is.
TEST(Respond, LosesNothingByRounding) {
  Pull pull{{.closure = mpm::CrackClosure::unilateral, .band = 1e-3}, mpm::intact_point(soft_mortar(), 1)};
  const Phase phase = soft_mortar();
  pull.point.phase = &phase;
  const mpm::Softening curve = mpm::softening(phase, Plane::strain, 6e6, 1e-3);
  (void)pull.to(curve.onset + 0.5 * curve.scale);
  pull.point.strength *= 1 - 1e-7;
  const Stress<double> here{0, 20e9 / (1 - 0.04) * pull.strain, 0};
  EXPECT_FALSE(mpm::respond(pull.point, here, pull.law).changed);
  pull.point.strength *= 1 - 1e-5;
  EXPECT_TRUE(mpm::respond(pull.point, here, pull.law).changed);
}

TEST(Respond, SoftensAndUnloadsToTheOrigin) {
  const Phase phase = soft_mortar();
  const mpm::Softening curve = mpm::softening(phase, Plane::strain, 6e6, 1e-3);
  Pull pull{{.band = 1e-3}, mpm::intact_point(phase, 1)};
  EXPECT_NEAR(pull.to(0.99 * curve.onset), 0.99 * 6e6, 1);
  const double first = curve.onset + 0.3 * curve.scale;
  const double carried = 6e6 * std::exp(-0.3);
  EXPECT_NEAR(pull.to(first), carried, 1e-9 * carried);
  EXPECT_NEAR(pull.to(0.4 * first), 0.4 * carried, 1e-9 * carried);
  EXPECT_NEAR(pull.to(-first), -carried, 1e-9 * carried) << "without closure the crack takes its stiffness";
  EXPECT_EQ(pull.failures, 0);
  EXPECT_NEAR(pull.to(curve.onset + curve.scale), 6e6 * std::exp(-1), 1);
  EXPECT_EQ(pull.failures, 1) << "half of the strength is lost";
  EXPECT_EQ(pull.to(curve.onset + 8 * curve.scale), 0);
  EXPECT_EQ(pull.failures, 1);
  EXPECT_TRUE(pull.point.spent);
}

// Pulled from both sides, a point is strained less at the same stress: its strength must not come back.
TEST(Respond, StrengthThatIsLostStaysLost) {
  const Phase phase = soft_mortar();
  Pull pull{{.band = 1e-3}, mpm::intact_point(phase, 1)};
  const double strength = pull.to(5e-3);
  const double elastic = 1.001 * strength / pull.point.kept;
  const mpm::Response response = mpm::respond(pull.point, {elastic, elastic, 0}, pull.law);
  ASSERT_TRUE(response.changed);
  EXPECT_LE(response.point.strength, strength);
  EXPECT_LE(mpm::carried_stress(response.point, {elastic, elastic, 0}, pull.law).xx, 1.0000001 * strength);
}

TEST(Respond, ASofteningCrackThatClosesIsAsStiffAsBeforeInCompression) {
  const Phase phase = soft_mortar();
  const mpm::Softening curve = mpm::softening(phase, Plane::strain, 6e6, 1e-3);
  for (const auto closure : {CrackClosure::clipped, CrackClosure::unilateral}) {
    Pull pull{{.closure = closure, .band = 1e-3}, mpm::intact_point(phase, 1)};
    const double first = curve.onset + 0.3 * curve.scale;
    const double carried = 6e6 * std::exp(-0.3);
    EXPECT_NEAR(pull.to(first), carried, 1e-9 * carried);
    EXPECT_NEAR(pull.to(-1e-3), -20e9 / (1 - 0.04) * 1e-3, 1) << "closed, as if it had never been";
    EXPECT_NEAR(pull.to(0.5 * first), 0.5 * carried, 1e-9 * carried);
    EXPECT_NEAR(pull.to(curve.onset + curve.scale), 6e6 * std::exp(-1), 1);
    EXPECT_EQ(pull.failures, 1);
  }
}

TEST(StressPower, IsTwiceTheElasticEnergyDensity) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const Eigen::Vector3d strain(1e-4, -3e-5, 2e-5);
    const Eigen::Vector3d s = mpm::stiffness(mortar, plane) * strain;
    const Stress<double> stress{s(0), s(1), s(2)};
    EXPECT_NEAR(mpm::stress_power(mortar, plane, stress, stress), strain.dot(s), 1e-9 * strain.dot(s));
  }
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

}  // namespace failure_test
