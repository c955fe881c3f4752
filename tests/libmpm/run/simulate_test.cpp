#include "libmpm/run/simulate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/plan.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace simulate_test {

using mpm::Direction;
using mpm::Platen;
using mpm::Precision;
using mpm::Result;
using mpm::Scene;

bool same_bits(const Result& a, const Result& b) {
  if (a.history.size() != b.history.size()) return false;
  const bool rows =
      std::memcmp(a.history.data(), b.history.data(), a.history.size() * sizeof(mpm::HistoryRow)) == 0;
  const auto bytes = static_cast<std::size_t>(a.failure_strain.size()) * sizeof(float);
  return rows && a.failure_strain.size() == b.failure_strain.size() &&
         std::memcmp(a.failure_strain.data(), b.failure_strain.data(), bytes) == 0 &&
         (a.failure_mode == b.failure_mode).all();
}

double end_modulus(const Result& result) {
  return result.history.back().stress / result.history.back().strain;
}

/// Slow, damped and elastic: at its end the run is as good as static (waves below 0.1 %).
Scene nearly_static(Scene scene) {
  scene = samples::unbreakable(std::move(scene));
  scene.loading.velocity = 0.02;
  scene.loading.stop_strain = 2e-4;
  scene.local_damping = 0.5;
  return scene;
}

TEST(Elastic, SmoothPlatensGiveThePlaneStrainModulus) {
  const Result result = mpm::simulate(nearly_static(samples::mortar_block(40, 40)));
  EXPECT_NEAR(end_modulus(result), 20e9 / (1 - 0.04), 2e-3 * 20e9);
}

TEST(Elastic, SmoothPlatensGiveYoungsModulusInPlaneStress) {
  Scene scene = nearly_static(samples::mortar_block(40, 40));
  scene.plane = mpm::Plane::stress;
  EXPECT_NEAR(end_modulus(mpm::simulate(scene)), 20e9, 2e-3 * 20e9);
}

TEST(Elastic, StressIsForceOverWidthAndStrainDisplacementOverHeight) {
  for (const auto& [rows, cols] : {std::pair{40, 20}, std::pair{20, 40}})
    EXPECT_NEAR(end_modulus(mpm::simulate(nearly_static(samples::mortar_block(rows, cols)))),
                20e9 / (1 - 0.04), 2e-3 * 20e9);
}

TEST(Elastic, RoughPlatensAreStiffer) {
  Scene scene = nearly_static(samples::mortar_block(40, 40));
  scene.loading.platen = Platen::rough;
  const double modulus = end_modulus(mpm::simulate(scene));
  EXPECT_GT(modulus, 1.003 * 20e9 / (1 - 0.04));
  EXPECT_LT(modulus, 22.2e9) << "the modulus with all lateral strain held";
}

// Layers with nu = 0: across them the moduli add in series (Reuss), along them in parallel (Voigt).
TEST(Elastic, LayersAcrossAndAlongTheLoad) {
  Scene scene = nearly_static(samples::mortar_block(40, 40));
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = 0;
  scene.labels.middleRows(0, 20).setConstant(samples::aggregate);
  EXPECT_NEAR(end_modulus(mpm::simulate(scene)), 1 / (0.5 / 40e9 + 0.5 / 20e9), 2e-3 * 27e9);
  scene.labels.setConstant(samples::mortar);
  scene.labels.middleCols(0, 20).setConstant(samples::aggregate);
  EXPECT_NEAR(end_modulus(mpm::simulate(scene)), 0.5 * (40e9 + 20e9), 2e-3 * 30e9);
}

TEST(Elastic, CompressionMirrorsTension) {
  Scene scene = nearly_static(samples::small_concrete(20, 20));
  const Result tension = mpm::simulate(scene);
  scene.loading.direction = Direction::compression;
  const Result compression = mpm::simulate(scene);
  EXPECT_DOUBLE_EQ(tension.history.back().stress, compression.history.back().stress);
}

TEST(Elastic, MorePointsACellChangeLittle) {
  Scene scene = nearly_static(samples::small_concrete(24, 24));
  const double two = end_modulus(mpm::simulate(scene));
  for (const int k : {1, 3, 4}) {
    scene.points_per_cell = k;
    EXPECT_NEAR(end_modulus(mpm::simulate(scene)), two, 0.05 * two) << k << " points along an edge";
  }
}

TEST(Ledger, ClosesToRoundingWhileTheSpecimenCracks) {
  Scene scene = samples::pulled(samples::small_concrete());
  const Result result = mpm::simulate(scene);
  ASSERT_GT(result.tension_failures, 200);
  EXPECT_LT(result.energy_error, 1e-11);
  scene.precision = Precision::single;
  EXPECT_LT(mpm::simulate(scene).energy_error, 1e-5);
}

TEST(Ledger, ClosesWithDampingAndResidualStiffness) {
  Scene scene = samples::pulled(samples::small_concrete());
  scene.damage.residual_stiffness = 0.1;
  EXPECT_LT(mpm::simulate(scene).energy_error, 1e-11);
  scene.local_damping = 0.3;
  const Result result = mpm::simulate(scene);
  EXPECT_GT(result.history.back().damped, 0.01 * result.history.back().platen_work);
  // Half a step of the damping force is counted too early, which is first order in the step.
  EXPECT_LT(result.energy_error, 1e-3);
}

TEST(Ledger, ErrorIsTheLargestImbalanceOverTheLargestWork) {
  Scene scene = samples::pulled(samples::small_concrete(20, 20));
  scene.local_damping = 0.3;
  const Result result = mpm::simulate(scene);
  double work = 0;
  double imbalance = 0;
  for (const auto& row : result.history) {
    work = std::max(work, std::abs(row.platen_work));
    imbalance = std::max(imbalance,
                         std::abs(row.platen_work - row.kinetic - row.elastic - row.released - row.damped));
  }
  EXPECT_GT(imbalance, 0);
  EXPECT_DOUBLE_EQ(result.energy_error, imbalance / work);
}

TEST(Ledger, KeepsEnergyWithUnilateralCracksInCompression) {
  Scene scene = samples::small_concrete();
  scene.loading.direction = Direction::compression;
  scene.loading.velocity = 0.4;
  scene.loading.stop_strain = 3e-3;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  const Result result = mpm::simulate(scene);
  EXPECT_GT(result.tension_failures, 500);
  EXPECT_LT(result.energy_error, 1e-3);
}

// Pixels that share their volume with extra points release their share only.
TEST(Ledger, ClosesWithExtraPointsWherePixelsFail) {
  Scene scene = samples::pulled(samples::small_concrete(40, 40));
  for (int i = 1; i < 40; ++i)
    for (int j = 1; j < 10; ++j) scene.extra_points.push_back({i * 0.5e-3, j * 2e-3 + 0.1e-3, samples::itz});
  const Result result = mpm::simulate(scene);
  EXPECT_GT(result.tension_failures, 200);
  EXPECT_LT(result.energy_error, 1e-11);
  scene.damage.residual_stiffness = 0.1;
  EXPECT_LT(mpm::simulate(scene).energy_error, 1e-11);
}

TEST(Ledger, KeepsEnergyWhenCrackedPointsAreCrushedToTheirResidualStiffness) {
  Scene scene = samples::small_concrete(20, 20);
  scene.loading.direction = Direction::compression;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 1e-2;
  for (auto& phase : scene.phases)
    if (phase && phase->can_shear()) phase->cohesion *= 0.1;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  scene.damage.residual_stiffness = 0.2;
  const Result result = mpm::simulate(scene);
  EXPECT_GT(result.shear_failures, 50);
  EXPECT_LT(result.energy_error, 1e-3);
}

TEST(Damage, TensionPeaksAndMapsAgreeWithTheCounts) {
  const Scene scene = samples::pulled(samples::small_concrete());
  const Result result = mpm::simulate(scene);
  EXPECT_GT(result.peak_stress, 1e6);
  EXPECT_LT(result.history.back().stress, 0.6 * result.peak_stress);
  std::int64_t marked = 0;
  for (Eigen::Index i = 0; i < result.failure_mode.size(); ++i) {
    const bool failed = result.failure_mode.data()[i] != 0;
    EXPECT_EQ(failed, !std::isnan(result.failure_strain.data()[i]));
    EXPECT_FALSE(failed && scene.labels.data()[i] == samples::aggregate) << "aggregates are elastic";
    marked += failed ? 1 : 0;
  }
  EXPECT_EQ(marked, result.tension_failures + result.shear_failures);
  EXPECT_EQ(result.history.back().tension_failures, result.tension_failures);
}

TEST(Damage, StrengthScalesWithTheTensileScale) {
  Scene scene = samples::pulled(samples::small_concrete());
  const double peak = mpm::simulate(scene).peak_stress;
  for (auto& phase : scene.phases)
    if (phase && phase->can_crack()) {
      phase->tensile_scale *= 0.5;
      phase->cohesion *= 0.5;
    }
  scene.loading.velocity *= 0.5;
  scene.loading.stop_strain *= 0.5;
  // Everything is linear in the strengths: half the strength at half the speed is half of all, bit by bit.
  EXPECT_DOUBLE_EQ(mpm::simulate(scene).peak_stress, 0.5 * peak);
}

TEST(Damage, AnotherSeedIsAnotherSpecimen) {
  Scene scene = samples::pulled(samples::small_concrete(20, 20));
  const Result first = mpm::simulate(scene);
  EXPECT_TRUE(same_bits(first, mpm::simulate(scene)));
  scene.damage.seed = 2;
  EXPECT_FALSE(same_bits(first, mpm::simulate(scene)));
}

TEST(Damage, ACrushedPointIsRecordedBesideItsCrack) {
  Scene scene = samples::small_concrete(20, 20);
  scene.loading.direction = Direction::compression;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 1e-2;
  for (auto& phase : scene.phases)
    if (phase && phase->can_shear()) phase->cohesion *= 0.1;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  const Result result = mpm::simulate(scene);
  std::int64_t crushed = 0;
  for (Eigen::Index i = 0; i < result.crush_strain.size(); ++i) {
    if (std::isnan(result.crush_strain.data()[i])) continue;
    ++crushed;
    EXPECT_EQ(result.failure_mode.data()[i], static_cast<std::uint8_t>(mpm::FailureMode::tension));
    EXPECT_GT(result.crush_strain.data()[i], result.failure_strain.data()[i]);
  }
  EXPECT_GT(crushed, 0);
  EXPECT_GT(result.shear_failures, crushed - 1);
}

TEST(Threads, GiveTheSameBits) {
  for (const Precision precision : {Precision::single, Precision::double_}) {
    Scene scene = samples::pulled(samples::small_concrete());
    scene.precision = precision;
    scene.extra_points = {{15e-3, 15e-3, samples::itz}, {10.1e-3, 20e-3, samples::itz}};
    const Result one = mpm::simulate(scene);
    for (const int threads : {2, 3, 5}) {
      scene.threads = threads;
      EXPECT_TRUE(same_bits(one, mpm::simulate(scene))) << threads << " threads";
    }
  }
}

// The history as well, however the rows are shared out while points fail and fly.
TEST(Threads, GiveTheSameBitsWhenPointsMove) {
  Scene scene = samples::small_concrete();
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading.direction = Direction::compression;
  scene.loading.velocity = 5;
  scene.loading.stop_strain = 0.02;
  scene.motion.left = scene.motion.right = mpm::Edge::open;
  scene.threads = 1;
  const Result one = mpm::simulate(scene);
  EXPECT_GT(one.history.back().released, 0);
  for (const int threads : {2, 3, 5}) {
    scene.threads = threads;
    EXPECT_TRUE(same_bits(one, mpm::simulate(scene))) << threads << " threads";
  }
}

TEST(InstructionSets, AgreeToRounding) {
  Scene scene = samples::pulled(samples::unbreakable(samples::small_concrete()));
  const Result fastest = mpm::simulate(scene);
  for (const auto* kernels : mpm::available_kernels()) {
    scene.instruction_set = kernels->name;
    const Result result = mpm::simulate(scene);
    EXPECT_EQ(result.instruction_set, kernels->name);
    EXPECT_NEAR(result.history.back().stress, fastest.history.back().stress, 1e-9 * fastest.peak_stress);
  }
  scene.instruction_set = "abacus";
  EXPECT_THROW((void)mpm::simulate(scene), mpm::Error);
}

// Kernels for one Poisson ratio and for several must agree where both apply: a ratio off by 1e-12 selects the
// other.
TEST(Features, OnePoissonRatioAndSeveralAgree) {
  Scene scene = samples::pulled(samples::small_concrete());
  const Result one = mpm::simulate(scene);
  scene.phases[samples::itz]->poisson += 1e-13;
  const Result several = mpm::simulate(scene);
  EXPECT_NEAR(several.peak_stress, one.peak_stress, 1e-6 * one.peak_stress);
  EXPECT_EQ(several.history[100].tension_failures, one.history[100].tension_failures);
}

TEST(Features, ATestThatCannotFailChangesNothing) {
  Scene scene = samples::pulled(samples::small_concrete());
  for (auto& phase : scene.phases)
    if (phase) phase->cohesion = 1e15;
  const Result with = mpm::simulate(scene);
  for (auto& phase : scene.phases)
    if (phase) phase->cohesion = mpm::Phase::unbreakable;
  EXPECT_TRUE(same_bits(with, mpm::simulate(scene)));
}

TEST(ExtraPoints, OfTheSameElasticPhaseChangeAlmostNothing) {
  Scene scene = nearly_static(samples::mortar_block(20, 20));
  const double plain = end_modulus(mpm::simulate(scene));
  for (int i = 1; i < 10; ++i)
    scene.extra_points.push_back({i * 1e-3 + 0.13e-3, i * 0.9e-3, samples::mortar});
  EXPECT_NEAR(end_modulus(mpm::simulate(scene)), plain, 2e-3 * plain);
}

TEST(ExtraPoints, FailAndAreCounted) {
  Scene scene = samples::pulled(samples::unbreakable(samples::mortar_block(20, 20)));
  auto weak = mpm::concrete_phases()[2];
  weak.tensile_scale = 0.5e6;
  scene.phases[samples::itz] = weak;
  for (int i = 1; i < 10; ++i) scene.extra_points.push_back({i * 1e-3, 5.1e-3, samples::itz});
  const Result result = mpm::simulate(scene);
  EXPECT_EQ(result.points, 409);
  EXPECT_EQ(result.tension_failures, 9);
  EXPECT_THAT(result.extra_failure_mode, testing::Each(static_cast<std::uint8_t>(mpm::FailureMode::tension)));
  EXPECT_LT(result.energy_error, 1e-11);
}

TEST(ExtraPoints, OfVoidAreNotCounted) {
  Scene scene = samples::pulled(samples::mortar_block(20, 20));
  scene.labels(0, 0) = 0;
  scene.extra_points = {{5e-3, 5e-3, 0}, {5e-3, 6e-3, samples::itz}};
  EXPECT_EQ(mpm::simulate(scene).points, 400);
}

TEST(Flight, StressIsTheReactionOfTheWallThatIsHit) {
  mpm::Scene scene = samples::soft_body(8, 8, 0.05);
  scene.loading.initial_velocity_y = -1;
  scene.loading.duration = 2e-3;
  scene.motion.bottom = mpm::Edge::smooth_wall;
  const mpm::Result result = mpm::simulate(scene);
  EXPECT_GT(result.peak_stress, 0.5 * 1000 * 100 * 1);  // rho c v, the stress of the first wave
  for (const mpm::HistoryRow& row : result.history) {
    EXPECT_EQ(row.stress, row.stress_bottom);
    EXPECT_EQ(row.stress_top, 0);
  }
  EXPECT_DOUBLE_EQ(result.history.back().strain, result.history.back().time * 1 / 0.4);
}

}  // namespace simulate_test
