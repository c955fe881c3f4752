#include "libmpm/scene/phase.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <limits>

#include "libmpm/scene/error.hpp"

namespace phase_test {

using mpm::Phase;
using mpm::Plane;

Phase mortar() { return mpm::concrete_phases()[1]; }

std::string message_of(const Phase& phase, Plane plane) {
  try {
    mpm::validate(phase, plane);
  } catch (const mpm::Error& error) {
    return error.what();
  }
  return "valid";
}

TEST(Stiffness, PlaneStrainFollowsHooke) {
  const auto c = mpm::stiffness(mortar(), Plane::strain);
  // E = 20 GPa, nu = 0.2: lambda = mu 2 nu / (1 - 2 nu) = 5.5556 GPa, mu = 8.3333 GPa.
  EXPECT_NEAR(c(0, 0), 22.2222e9, 1e5);
  EXPECT_NEAR(c(0, 1), 5.55556e9, 1e5);
  EXPECT_NEAR(c(2, 2), 8.33333e9, 1e5);
  EXPECT_EQ(c, c.transpose());
}

TEST(Stiffness, PlaneStressGivesYoungsModulusInUniaxialStress) {
  const Eigen::Vector3d strain =
      mpm::stiffness(mortar(), Plane::stress).inverse() * Eigen::Vector3d(1e6, 0, 0);
  EXPECT_NEAR(strain(0), 1e6 / 20e9, 1e-15);
  EXPECT_NEAR(strain(1), -0.2 * 1e6 / 20e9, 1e-15);
}

TEST(WaveSpeed, IsThatOfTheCompressionWave) {
  // Aggregate of the paper in plane strain: 4303 m/s, from which 10,327 steps of the tension test follow.
  EXPECT_NEAR(mpm::wave_speed(mpm::concrete_phases()[0], Plane::strain), 4303.3, 0.1);
}

TEST(Validate, NamesTheFirstValueOutOfRange) {
  Phase phase = mortar();
  EXPECT_EQ(message_of(phase, Plane::strain), "valid");
  phase.young = -20e9;
  EXPECT_EQ(message_of(phase, Plane::strain), "phases.mortar.young: -2e+10 Pa; must be > 0");
  phase = mortar();
  phase.poisson = 0.5;
  EXPECT_EQ(message_of(phase, Plane::strain),
            "phases.mortar.poisson: 0.5; must lie in [0, 0.4999] in plane strain");
  EXPECT_EQ(message_of(phase, Plane::stress), "valid");
  phase = mortar();
  phase.weibull_modulus = 0;
  EXPECT_EQ(message_of(phase, Plane::strain), "phases.mortar.weibull_modulus: 0; must be > 0");
  phase = mortar();
  phase.friction_angle = 2;
  EXPECT_EQ(message_of(phase, Plane::strain),
            "phases.mortar.friction_angle: 114.592 deg; must lie in [0, 90) deg");
  phase = mortar();
  phase.poisson = -0.1;
  EXPECT_THAT(message_of(phase, Plane::strain),
              testing::HasSubstr("phases.mortar.poisson: -0.1; must lie in"));
  phase = mortar();
  phase.density = 0;
  EXPECT_EQ(message_of(phase, Plane::strain), "phases.mortar.density: 0 kg/m3; must be > 0");
}

TEST(Validate, RefusesNotANumberEverywhere) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (double Phase::*field : {&Phase::young, &Phase::poisson, &Phase::density, &Phase::tensile_scale,
                               &Phase::cohesion, &Phase::friction_angle, &Phase::weibull_modulus}) {
    Phase phase = mortar();
    phase.*field = nan;
    EXPECT_THROW(mpm::validate(phase, Plane::strain), mpm::Error);
  }
}

}  // namespace phase_test
