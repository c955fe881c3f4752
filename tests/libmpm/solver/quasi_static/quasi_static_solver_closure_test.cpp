// Cracks that close again, in equilibrium.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/strength.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/quasi_static/equilibrium.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"
#include "tests/libmpm/sample_scenes.hpp"
#include "tests/libmpm/solver/quasi_static/quasi_static_runs.hpp"

namespace quasi_static_solver_closure_test {

using mpm::Direction;
using mpm::Equilibrium;
using mpm::Result;
using mpm::Scene;

Scene closing(Scene scene, bool pixel, Direction direction) {
  scene.method = mpm::SolverMethod::quasi_static;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  scene.pixel_cells = pixel;
  scene.points_per_cell = pixel ? 1 : 2;
  scene.loading.direction = direction;
  return scene;
}

Scene block(bool pixel, Direction direction, double poisson) {
  Scene scene = closing(samples::mortar_block(12, 8), pixel, direction);
  for (auto& phase : scene.phases)
    if (phase) phase->poisson = poisson;
  return scene;
}

/// Over the modulus of the intact block, once the points of these rows of cells have lost a share of their
/// tensile strength.
double remaining(const Scene& scene, int first, int last, double cracked) {
  const mpm::Plan plan = mpm::plan(scene);
  Equilibrium equilibrium(scene, plan, mpm::StrengthFactors(scene, false));
  EXPECT_TRUE(equilibrium.solve(0));
  const double intact = equilibrium.modulus();
  std::vector<Equilibrium::Change> changes;
  for (int row = first; row <= last; ++row)
    equilibrium.each_point(row, [&](const mpm::PointPlace& at) { changes.push_back({at, 1, cracked}); });
  equilibrium.change(changes);
  EXPECT_TRUE(equilibrium.solve(1e-6));
  return equilibrium.modulus() / intact;
}

TEST(QuasiStaticClosure, ACrackedRowCarriesCompressionAsIfItWereIntact) {
  for (const bool pixel : {true, false})
    for (const double cracked : {0.25, 1.0})
      EXPECT_NEAR(remaining(block(pixel, Direction::compression, 0), 2, 2, cracked), 1, 1e-6);
}

TEST(QuasiStaticClosure, ACrackedRowCarriesItsShareOfTension) {
  for (const bool pixel : {true, false}) {
    const double rows = pixel ? 12 : 6;
    const double expected = rows / (rows - 1 + 1 / (1 - 0.25));
    EXPECT_NEAR(remaining(block(pixel, Direction::tension, 0), 2, 2, 0.25), expected, 1e-6);
    EXPECT_LT(remaining(block(pixel, Direction::tension, 0), 2, 2, 1), 2e-5);
  }
}

// Cracks along the load, opened by Poisson's effect: nothing holds them together, and nothing needs to.
TEST(QuasiStaticClosure, ABlockOfCracksCarriesUniaxialCompression) {
  for (const bool pixel : {true, false})
    EXPECT_NEAR(remaining(block(pixel, Direction::compression, 0.2), 0, pixel ? 11 : 5, 1), 1, 2e-6);
}

// Between rough platens the cracks at the sides open, and the law is followed on both sides of its kinks.
TEST(QuasiStaticClosure, RoughPlatensHoldABlockOfCracksLessThanAnIntactOne) {
  for (const bool pixel : {true, false}) {
    Scene scene = block(pixel, Direction::compression, 0.2);
    scene.loading.platen = mpm::Platen::rough;
    const double share = remaining(scene, 0, pixel ? 11 : 5, 1);
    EXPECT_LT(share, 0.9999999);
    EXPECT_GT(share, 0.9);
  }
}

TEST(QuasiStaticClosure, AWeakRowTearsAsWithoutIt) {
  for (const bool pixel : {true, false}) {
    Scene scene = samples::unbreakable(block(pixel, Direction::tension, 0));
    scene.loading.stop_strain = 1e-2;
    mpm::Phase weak = *scene.phases[2];
    weak.tensile_scale = 3e6;
    weak.weibull_modulus = 1e9;
    scene.phases[samples::aggregate] = weak;
    scene.labels.middleRows(4, 2).setConstant(samples::aggregate);
    const Result with = mpm::simulate(scene);
    scene.damage.crack_closure = mpm::CrackClosure::off;
    const Result without = mpm::simulate(scene);
    EXPECT_EQ(with.peak_stress, without.peak_stress);
    EXPECT_EQ(with.tension_failures, without.tension_failures);
    EXPECT_LT(with.history.back().stress, 1e-3 * with.peak_stress);
    EXPECT_NEAR(with.history.back().released, without.history.back().released,
                1e-3 * without.history.back().released);
  }
}

// A crack band dissipates its fracture energy, also on the path that snaps back.
TEST(QuasiStaticClosure, ACrackBandDissipatesItsFractureEnergy) {
  for (const auto path : {mpm::LoadingPath::strain, mpm::LoadingPath::snap_back}) {
    Scene scene = samples::unbreakable(block(true, Direction::tension, 0));
    scene.loading.path = path;
    scene.loading.stop_strain = 0.5;
    mpm::Phase weak = *scene.phases[2];
    weak.tensile_scale = 3e6;
    weak.weibull_modulus = 1e9;
    weak.fracture_energy = 60;
    scene.phases[samples::aggregate] = weak;
    scene.labels.row(5).setConstant(samples::aggregate);
    const Result result = mpm::simulate(scene);
    EXPECT_NEAR(result.peak_stress, 3e6, 100);
    EXPECT_NEAR(result.history.back().released, 60 * scene.width(), 0.01 * 60 * scene.width());
  }
}

// So does a shear band, and reaches its strength.
TEST(QuasiStaticClosure, AShearBandDissipatesItsFractureEnergy) {
  for (const auto path : {mpm::LoadingPath::strain, mpm::LoadingPath::snap_back}) {
    Scene scene = samples::unbreakable(block(true, Direction::compression, 0));
    scene.loading.path = path;
    scene.loading.stop_strain = 0.5;
    mpm::Phase weak = *scene.phases[2];
    weak.cohesion = 4e6;
    weak.friction_angle = 0.5;
    weak.weibull_modulus = 1e9;
    weak.shear_fracture_energy = 500;
    scene.phases[samples::aggregate] = weak;
    scene.labels.row(5).setConstant(samples::aggregate);
    const Result result = mpm::simulate(scene);
    const double strength = mpm::compressive_strength(weak, 1);
    EXPECT_NEAR(result.peak_stress, strength, 1e-4 * strength);
    EXPECT_NEAR(result.history.back().released, 500 * scene.width(), 0.01 * 500 * scene.width());
    EXPECT_EQ(result.shear_failures, scene.labels.cols());
  }
}

// Cracks and shear bands together, and what is known of them when a run goes on.
TEST(QuasiStaticClosure, ShearBandsFollowSlowDampedLoading) {
  Scene scene = closing(samples::small_concrete(24, 24), true, Direction::compression);
  samples::set_fracture_energy(scene, 100);
  for (const auto label : {samples::mortar, samples::itz}) {
    scene.phases[label]->cohesion = label == samples::itz ? 6e6 : 10e6;
    scene.phases[label]->weibull_modulus = 12;
    scene.phases[label]->shear_fracture_energy = 3000;
  }
  scene.loading.stop_strain = 6e-3;
  const Result still = mpm::simulate(scene);
  EXPECT_GT(still.shear_failures, 5);
  EXPECT_LT(still.peak_strain, 5e-3);
  EXPECT_LT(still.energy_error, 1e-9);
  const samples::Interrupted run = samples::stopped_after(scene, static_cast<int>(still.history.size() / 2));
  const Result resumed = mpm::resume(scene, run.kept);
  EXPECT_EQ(resumed.history.back().stress, still.history.back().stress);
  scene.method = mpm::SolverMethod::explicit_;
  scene.loading.velocity = 0.1;
  scene.loading.stop_strain = 1.3 * still.peak_strain;
  scene.local_damping = 0.3;
  const Result slow = mpm::simulate(scene);
  EXPECT_NEAR(slow.peak_stress, still.peak_stress, 0.04 * still.peak_stress);
}

Scene concrete(Direction direction, bool pixel = true) {
  Scene scene = closing(samples::small_concrete(24, 24), pixel, direction);
  scene.loading.stop_strain = direction == Direction::tension ? 4e-4 : 8e-3;
  for (auto& phase : scene.phases)
    if (phase && phase->can_shear()) phase->cohesion *= 0.5;  // so that cracks are crushed, too
  return scene;
}

TEST(QuasiStaticClosure, TheLedgerClosesAndNothingIsWonByFailing) {
  for (const bool pixel : {true, false})
    for (const auto path : {mpm::LoadingPath::strain, mpm::LoadingPath::snap_back}) {
      Scene scene = concrete(Direction::compression, pixel);
      scene.loading.path = path;
      scene.loading.stop_strain = 4e-3;
      const Result result = mpm::simulate(scene);
      EXPECT_LT(result.energy_error, 1e-12);
      for (std::size_t i = 1; i < result.history.size(); ++i)
        EXPECT_GE(result.history[i].released, result.history[i - 1].released * (1 - 1e-9)) << i;
      std::int64_t crushed = 0;
      for (const float strain : result.crush_strain.reshaped()) crushed += std::isnan(strain) ? 0 : 1;
      EXPECT_GT(crushed, 3);
      EXPECT_GE(result.shear_failures, crushed);
    }
}

TEST(QuasiStaticClosure, StrengthInCompressionGrows) {
  Scene scene = closing(samples::small_concrete(24, 24), true, Direction::compression);
  scene.loading.stop_strain = 5e-3;
  const Result with = mpm::simulate(scene);
  scene.damage.crack_closure = mpm::CrackClosure::off;
  const Result without = mpm::simulate(scene);
  EXPECT_GT(with.peak_stress, 1.3 * without.peak_stress);
}

TEST(QuasiStaticClosure, IsTheLimitOfSlowDampedLoading) {
  Scene scene = concrete(Direction::compression);
  scene.event_tolerance = 0;
  scene.loading.stop_strain = 2e-3;
  const Result still = mpm::simulate(scene);
  scene.method = mpm::SolverMethod::explicit_;
  scene.loading.velocity = 0.01;
  scene.local_damping = 0.3;
  const Result slow = mpm::simulate(scene);
  EXPECT_NEAR(slow.history.back().stress, still.history.back().stress, 0.02 * still.peak_stress);
}

TEST(QuasiStaticClosure, GoesOnAsIfItHadNeverStopped) {
  for (const double energy : {0.0, 100.0}) {
    Scene scene = concrete(Direction::compression);
    samples::set_fracture_energy(scene, energy);
    scene.loading.stop_strain = 3e-3;
    const Result whole = mpm::simulate(scene);
    const samples::Interrupted run =
        samples::stopped_after(scene, static_cast<int>(whole.history.size() / 2));
    EXPECT_EQ(run.half.stop, mpm::StopReason::interrupted);
    const Result resumed = mpm::resume(scene, run.kept);
    ASSERT_EQ(resumed.history.size(), whole.history.size());
    for (std::size_t i = 0; i < whole.history.size(); ++i)
      EXPECT_EQ(resumed.history[i].stress, whole.history[i].stress) << i;
    EXPECT_EQ(resumed.shear_failures, whole.shear_failures);
    EXPECT_EQ(resumed.tension_failures, whole.tension_failures);
  }
}

TEST(QuasiStaticClosure, FailsAlikeOnAnyNumberOfThreads) {
  Scene scene = closing(samples::small_concrete(130, 110), true, Direction::compression);
  scene.loading.stop_strain = 3.5e-4;
  scene.event_tolerance = 0.1;
  const auto run = [&](int threads) {
    scene.threads = threads;
    return mpm::simulate(scene);
  };
  const Result one = run(1);
  EXPECT_GT(one.tension_failures, 40);
  const Result three = run(3);
  ASSERT_EQ(three.history.size(), one.history.size());
  for (std::size_t i = 0; i < one.history.size(); ++i)
    EXPECT_EQ(three.history[i].stress, one.history[i].stress) << i;
  EXPECT_TRUE((three.failure_mode == one.failure_mode).all());
}

}  // namespace quasi_static_solver_closure_test
