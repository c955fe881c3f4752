#include "libmpm/run/explain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/solver/frame.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"
#include "libmpm/solver/moving/moving_points.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace explain_test {

const mpm::Feature& feature(const mpm::Explanation& explanation, const std::string& name) {
  const auto found = std::find_if(explanation.features.begin(), explanation.features.end(),
                                  [&](const mpm::Feature& one) { return one.name == name; });
  EXPECT_NE(found, explanation.features.end()) << name;
  return *found;
}

mpm::Scene moving(mpm::Scene scene) {
  scene.kinematics = mpm::Kinematics::moving;
  return scene;
}

/// Bytes that the arrays of the lattice hold for a point, failure maps aside.
template <class Real>
double bytes_of_points(const mpm::Scene& scene) {
  const mpm::Plan plan = mpm::plan(scene);
  const auto points = mpm::make_points<Real>(scene, plan, mpm::StrengthFactors(scene, false));
  const auto size = static_cast<double>(points.stiffness.size());
  const std::size_t reals = points.stiffness.size() + points.shear.size();
  const std::size_t floats = points.tension.size() + points.crush.size() + points.cracked.size();
  return static_cast<double>(reals * sizeof(Real) + floats * sizeof(float)) / size;
}

TEST(Explain, CountsTheBytesThatThePointsOfTheLatticeTake) {
  mpm::Scene scene = samples::small_concrete(20, 20);
  EXPECT_EQ(mpm::explain(scene).bytes, bytes_of_points<double>(scene) + 5)
      << "5 bytes a pixel of failure maps";
  EXPECT_EQ(mpm::explain(samples::unbreakable(scene)).bytes,
            bytes_of_points<double>(samples::unbreakable(scene)));
  scene.phases[samples::itz]->poisson = 0.3;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  scene.precision = mpm::Precision::single;
  EXPECT_EQ(mpm::explain(scene).bytes, bytes_of_points<float>(scene) + 9);
}

TEST(Explain, WhatIsLeftOutSavesWhatTheOtherRunHas) {
  mpm::Scene with = samples::small_concrete(20, 20);
  mpm::Scene without = samples::unbreakable(with);
  for (const bool moves : {false, true}) {
    if (moves) {
      with = moving(with);
      without = moving(without);
    }
    const mpm::Explanation more = mpm::explain(with);
    const mpm::Explanation less = mpm::explain(without);
    double difference = 0;
    for (const char* name :
         {"tension test and its threshold", "shear test and its threshold", "failure maps"}) {
      EXPECT_TRUE(feature(more, name).in) << name;
      EXPECT_FALSE(feature(less, name).in) << name;
      EXPECT_EQ(feature(more, name).bytes, feature(less, name).bytes) << name;
      difference += feature(less, name).bytes;
    }
    EXPECT_EQ(more.bytes - less.bytes, difference);
  }
}

TEST(Explain, CountsTheRecordOfAMovingPoint) {
  mpm::Scene scene = moving(samples::small_concrete(20, 20));
  const mpm::Explanation flip = mpm::explain(scene);
  EXPECT_EQ(flip.kinematics, "moving points");
  scene.motion.transfer = mpm::Transfer::apic;
  scene.motion.deformation_gradient = true;
  const mpm::Explanation apic = mpm::explain(scene);
  EXPECT_EQ(apic.bytes - flip.bytes, feature(flip, "velocity gradient of the points (APIC)").bytes +
                                         feature(flip, "deformation gradient").bytes);
  // What the storage really holds for a point when it is full.
  const mpm::Plan plan = mpm::plan(scene);
  EXPECT_EQ(apic.bytes, mpm::record_layout(plan.moving.optional).fields * 8 + 4 + 5);
}

TEST(Explain, CountsTheFrameThatARunKeeps) {
  for (const bool moves : {false, true}) {
    mpm::Scene scene = samples::small_concrete(20, 20);
    if (moves) scene = moving(scene);
    const mpm::Explanation less = mpm::explain(scene);
    scene.frames = 7;
    const mpm::Explanation more = mpm::explain(scene);
    const char* name = "frames for ParaView";
    EXPECT_FALSE(feature(less, name).in);
    EXPECT_TRUE(feature(more, name).in);
    EXPECT_EQ(feature(more, name).why, "output.frames is 7; one at a time is in memory");
    EXPECT_EQ(more.bytes - less.bytes, sizeof(mpm::FramePoint));
    EXPECT_EQ(feature(less, name).bytes, sizeof(mpm::FramePoint));
  }
}

TEST(Explain, SaysWhatIsInFirstAndGivesAReasonForEach) {
  const mpm::Explanation explanation = mpm::explain(samples::small_concrete(20, 20));
  EXPECT_TRUE(std::is_partitioned(explanation.features.begin(), explanation.features.end(),
                                  [](const mpm::Feature& one) { return one.in; }));
  for (const mpm::Feature& one : explanation.features) EXPECT_FALSE(one.why.empty()) << one.name;
  EXPECT_GT(explanation.time, 0);
}

TEST(Explain, TimesTheFirstStepsOfARunThatIsShorterThanTheStretches) {
  mpm::Scene scene = samples::small_concrete(20, 20);
  scene.loading.stop_strain = 1e-9;
  EXPECT_GT(mpm::explain(scene).time, 0);
}

// Timing with and without: moving points cost a multiple of the lattice, far beyond what a busy machine
// blurs.
TEST(Explain, MeasuresThatMovingPointsCostMoreThanTheLattice) {
  const mpm::Explanation explanation = mpm::explain(samples::small_concrete(60, 60));
  const mpm::Feature& motion = feature(explanation, "moving points");
  EXPECT_FALSE(motion.in);
  ASSERT_TRUE(motion.time.has_value());
  EXPECT_GT(*motion.time, explanation.time);
}

}  // namespace explain_test
