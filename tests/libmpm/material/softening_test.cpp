#include "libmpm/material/softening.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/failure.hpp"
#include "libmpm/material/strength.hpp"

namespace softening_test {

using mpm::CrackClosure;
using mpm::FailureMode;
using mpm::Phase;
using mpm::Plane;
using mpm::SofteningCurve;
using mpm::Stress;

mpm::Phase softening_mortar() {
  mpm::Phase phase = mpm::concrete_phases()[1];
  phase.fracture_energy = 60;
  return phase;
}

// Area under the stress-strain curve of a bar, times the width of the band.
TEST(Softening, DissipatesTheFractureEnergyInABandOfAnyWidth) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    for (const double band : {0.25e-3, 1e-3, 4e-3}) {
      const mpm::Softening curve = mpm::softening(softening_mortar(), plane, 6e6, band);
      double area = 0.5 * curve.peak * curve.onset;
      const int n = 40000;
      const double step = 20 * curve.scale / n;
      for (int i = 0; i < n; ++i) area += step * curve.stress_at(curve.onset + (i + 0.5) * step);
      EXPECT_NEAR(area * band, 60, 1e-4 * 60);
    }
  }
}

TEST(Softening, FallsAsItsSourceSays) {
  mpm::Phase phase = softening_mortar();
  const auto curve_of = [&](SofteningCurve shape) {
    phase.softening = shape;
    return mpm::softening(phase, Plane::stress, 6e6, 1e-6);
  };
  // Openings, over which the band of a micrometre is nothing.
  const auto share = [&](SofteningCurve shape, double opening) {
    const mpm::Softening curve = curve_of(shape);
    return curve.stress_at(curve.onset + opening / 1e-6) / 6e6;
  };
  const double unit = 60 / 6e6;  // G_f / f_t [m]
  EXPECT_NEAR(share(SofteningCurve::bilinear, 0.8 * unit), 1.0 / 3, 1e-4);
  EXPECT_NEAR(share(SofteningCurve::bilinear, 2.2 * unit), 1.0 / 6, 1e-4);
  EXPECT_EQ(share(SofteningCurve::bilinear, 3.7 * unit), 0);
  const double last = 5.136 * unit;
  EXPECT_NEAR(share(SofteningCurve::hordijk, 0.1 * last),
              1.027 * std::exp(-0.693) - 0.1 * 28 * std::exp(-6.93), 1e-4);
  EXPECT_NEAR(share(SofteningCurve::hordijk, 0.999 * last), 0, 1e-3);
  EXPECT_EQ(share(SofteningCurve::hordijk, 1.01 * last), 0);
}

TEST(Softening, OfEveryCurveDissipatesTheFractureEnergy) {
  mpm::Phase phase = softening_mortar();
  for (const auto shape : {SofteningCurve::exponential, SofteningCurve::bilinear, SofteningCurve::hordijk}) {
    phase.softening = shape;
    const mpm::Softening curve = mpm::softening(phase, Plane::strain, 6e6, 1e-3);
    double area = 0;
    const int n = 40000;
    const double step = 20 * curve.scale / n;
    for (int i = 0; i < n; ++i) {
      const double strain = curve.onset + (i + 0.5) * step;
      area += step * curve.stress_at(strain);
      if (i % 4000 == 0) {
        EXPECT_NEAR(curve.area_to(strain + 0.5 * step), area, 1e-6 * curve.peak * curve.scale) << i;
      }
    }
    EXPECT_NEAR((0.5 * curve.peak * curve.onset + area) * 1e-3, 60, 1e-3 * 60);
  }
}

TEST(Softening, TeethOfEveryCurveDissipateTheFractureEnergy) {
  mpm::Phase phase = softening_mortar();
  for (const auto shape : {SofteningCurve::exponential, SofteningCurve::bilinear, SofteningCurve::hordijk}) {
    phase.softening = shape;
    const mpm::Softening curve = mpm::softening(phase, Plane::strain, 6e6, 1e-3);
    const double young = curve.peak / curve.onset;
    mpm::Tooth tooth{1, curve.peak};
    double released = 0;
    while (tooth.kept > 0) {
      const double strain = tooth.strength / (tooth.kept * young);
      const mpm::Tooth next = mpm::next_tooth(curve, tooth.kept, young * strain);
      released += 0.5 * (tooth.kept - next.kept) * young * strain * strain;
      EXPECT_LE(next.strength, curve.peak);
      tooth = next;
    }
    EXPECT_NEAR(released * 1e-3, 60, 0.01 * 60) << static_cast<int>(shape);
  }
}

TEST(Softening, BeginsAtTheStrainOfABarThatIsFreeSideways) {
  EXPECT_DOUBLE_EQ(mpm::softening(softening_mortar(), Plane::strain, 6e6, 1e-3).onset,
                   6e6 * (1 - 0.04) / 20e9);
  EXPECT_DOUBLE_EQ(mpm::softening(softening_mortar(), Plane::stress, 6e6, 1e-3).onset, 6e6 / 20e9);
  EXPECT_EQ(mpm::softening(softening_mortar(), Plane::stress, 6e6, 1e-3).stress_at(1e-4), 6e6);
}

TEST(Softening, SnapsBackBeyondTheWidestBand) {
  const double widest = mpm::widest_band(softening_mortar(), Plane::stress, 6e6);
  EXPECT_DOUBLE_EQ(widest, 2 * 20e9 * 60 / 36e12);
  EXPECT_GT(mpm::softening(softening_mortar(), Plane::stress, 6e6, 0.99 * widest).scale, 0);
  EXPECT_LT(mpm::softening(softening_mortar(), Plane::stress, 6e6, 1.01 * widest).scale, 0);
}

TEST(Softening, TeethKeepPeakAndFractureEnergy) {
  mpm::Phase phase = mpm::concrete_phases()[1];
  for (const double energy : {15.0, 60.0, 400.0}) {
    phase.fracture_energy = energy;
    const double young = phase.young / (1 - phase.poisson * phase.poisson);
    const double band = 0.5e-3;
    const mpm::Softening curve = mpm::softening(phase, mpm::Plane::strain, 3e6, band);
    double released = 0;
    int teeth = 0;
    mpm::Tooth now{1, curve.peak};
    while (now.kept > 0) {
      const double strain = now.strength / (now.kept * young);
      const mpm::Tooth next = mpm::next_tooth(curve, now.kept, young * strain);
      // The triangle between the secants of this tooth and of the next one is what breaks.
      released += 0.5 * (now.kept - next.kept) * young * strain * strain;
      EXPECT_LT(next.kept, now.kept);
      EXPECT_LE(next.strength, curve.peak);
      if (next.kept > 0) {
        EXPECT_NEAR(next.strength, curve.stress_at(strain), 0.15 * curve.peak) << strain;
      }
      now = next;
      ++teeth;
    }
    EXPECT_NEAR(released * band, energy, 0.005 * energy) << teeth;
    EXPECT_LT(teeth, 200);
  }
}

mpm::Phase shearing_mortar() {
  mpm::Phase phase = mpm::concrete_phases()[1];
  phase.cohesion = 8e6;
  phase.friction_angle = 0.6;
  phase.tensile_scale = mpm::Phase::unbreakable;
  phase.shear_fracture_energy = 500;
  return phase;
}

// A bar that is free sideways is pressed together: what it takes in, times the width of the band.
TEST(ShearSoftening, DissipatesItsFractureEnergyInABandOfAnyWidth) {
  const mpm::Phase phase = shearing_mortar();
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const double modulus = mpm::bar_modulus(phase, plane);
    for (const double band : {0.25e-3, 1e-3, 4e-3}) {
      const mpm::DamageLaw law{.plane = plane, .closure = CrackClosure::unilateral, .band = band};
      mpm::PointState point = mpm::intact_point(phase, 1.3);
      const double onset = mpm::compressive_strength(phase, 1.3) / modulus;
      const double step = onset / 2000;
      double area = 0;
      double before = 0;
      int failures = 0;
      for (double strain = step; !point.spent; strain += step) {
        ASSERT_LT(strain, 1e4 * onset);
        const Stress<double> elastic{0, -modulus * strain, 0};
        const mpm::Response response = mpm::respond(point, elastic, law);
        point = response.point;
        failures += response.failure == mpm::FailureMode::shear ? 1 : 0;
        const double stress = -mpm::carried_stress(point, elastic, law).yy;
        area += 0.5 * (before + stress) * step;
        before = stress;
      }
      EXPECT_NEAR(area * band, 500, 0.01 * 500) << band;
      EXPECT_EQ(failures, 1) << "when half of the cohesion is lost";
    }
  }
}

TEST(ShearSoftening, UnloadsToTheOriginAndGoesOnWhereItWas) {
  const mpm::Phase phase = shearing_mortar();
  const mpm::DamageLaw law{.closure = CrackClosure::unilateral, .band = 1e-3};
  const double strength = mpm::compressive_strength(phase, 1);
  const auto press = [&](mpm::PointState& point, double times) {
    const Stress<double> elastic{0, -times * strength, 0};
    point = mpm::respond(point, elastic, law).point;
    return -mpm::carried_stress(point, elastic, law).yy / strength;
  };
  mpm::PointState point = mpm::intact_point(phase, 1);
  EXPECT_DOUBLE_EQ(press(point, 0.999), 0.999);
  const mpm::Softening curve = mpm::shear_softening(phase, Plane::strain, 1, 1e-3);
  const double times = 1 + 0.4 * curve.scale;
  EXPECT_NEAR(press(point, times), std::exp(-0.4), 1e-12);
  EXPECT_NEAR(mpm::remaining_cohesion(point, law), std::exp(-0.4), 1e-9);
  EXPECT_NEAR(press(point, 0.5 * times), 0.5 * std::exp(-0.4), 1e-12);
  EXPECT_NEAR(press(point, 1 + 0.8 * curve.scale), std::exp(-0.8), 1e-12);
}

// Its cracks open and close meanwhile: tension must not give back what shear took.
TEST(ShearSoftening, KeepsWhatACrackHasTaken) {
  mpm::Phase phase = shearing_mortar();
  phase.tensile_scale = 4e6;
  phase.fracture_energy = 60;
  const mpm::DamageLaw law{.closure = CrackClosure::unilateral, .band = 1e-3};
  mpm::PointState point = mpm::intact_point(phase, 1);
  const double strength = mpm::compressive_strength(phase, 1);
  point = mpm::respond(point, {0, -3 * strength, 0}, law).point;
  const double kept = point.kept;
  EXPECT_LT(kept, 0.5);
  const Stress<double> pull{0, 8e6 / kept, 0};
  point = mpm::respond(point, pull, law).point;
  EXPECT_EQ(point.kept, kept);
  EXPECT_GT(point.cracked, 0);
  EXPECT_LE(mpm::carried_stress(point, pull, law).yy, 4e6);
  const double cracked = point.cracked;
  point = mpm::respond(point, {0, -4 * strength, 0}, law).point;
  EXPECT_LT(point.kept, kept);
  EXPECT_EQ(point.cracked, cracked);
}

TEST(ShearSoftening, SnapsBackBeyondTheWidestBand) {
  const mpm::Phase phase = shearing_mortar();
  const double widest = mpm::widest_shear_band(phase, Plane::stress, 1);
  EXPECT_GT(mpm::shear_softening(phase, Plane::stress, 1, 0.99 * widest).scale, 0);
  EXPECT_LT(mpm::shear_softening(phase, Plane::stress, 1, 1.01 * widest).scale, 0);
}

TEST(Softening, TeethThatAreExceededArePassedOver) {
  mpm::Phase phase = mpm::concrete_phases()[1];
  phase.fracture_energy = 60;
  const mpm::Softening curve = mpm::softening(phase, mpm::Plane::strain, 3e6, 0.5e-3);
  const double young = curve.peak / curve.onset;
  const mpm::Tooth far = mpm::next_tooth(curve, 1, young * 20 * curve.onset);
  EXPECT_GT(far.strength / (far.kept * young), 20 * curve.onset);
  EXPECT_LT(far.kept, 0.05);
  EXPECT_EQ(mpm::next_tooth(curve, 1, young * 1e6 * curve.onset).kept, 0);
}

}  // namespace softening_test
