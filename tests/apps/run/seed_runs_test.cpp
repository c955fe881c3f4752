#include "apps/run/seed_runs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "apps/job/job.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/apps/small_specimen.hpp"

namespace seed_runs_test {

using app::RunEnd;
using app::SeedRun;

bool never() { return false; }

mpm::Scene small_scene() { return app::build_scene(test::small_specimen(), test::small_settings()); }

TEST(SeedRuns, AreThoseOfTheSceneWithEachSeed) {
  mpm::Scene scene = small_scene();
  const auto runs = app::run_seeds(scene, app::seeds_from(3, 3), RunEnd::of_scene, never);
  ASSERT_TRUE(runs);
  ASSERT_EQ(runs->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    scene.damage.seed = 3 + i;
    const mpm::Result alone = mpm::simulate(scene);
    EXPECT_EQ((*runs)[i].seed, 3 + i);
    EXPECT_EQ((*runs)[i].peak_stress, alone.peak_stress);
    EXPECT_EQ((*runs)[i].peak_strain, alone.peak_strain);
    EXPECT_EQ((*runs)[i].curve.stress.back(), alone.history.back().stress);
  }
  EXPECT_NE((*runs)[0].peak_stress, (*runs)[1].peak_stress);
}

TEST(SeedRuns, PastThePeakEndEarlyWithTheSamePeak) {
  mpm::Scene scene = small_scene();
  const auto whole = app::run_seeds(scene, {1}, RunEnd::of_scene, never);
  const auto brief = app::run_seeds(scene, {1}, RunEnd::past_peak, never);
  EXPECT_NEAR(brief->front().peak_stress, whole->front().peak_stress, 1e-3 * whole->front().peak_stress);
  EXPECT_LT(brief->front().curve.strain.back(), 0.8 * scene.loading.stop_strain);
}

TEST(SeedRuns, FindAPeakBeyondTheEndOfTheScene) {
  mpm::Scene scene = small_scene();
  const auto whole = app::run_seeds(scene, {1}, RunEnd::of_scene, never);
  scene.loading.stop_strain = 0.2 * whole->front().peak_strain;
  scene.history_rows = 200;
  const auto found = app::run_seeds(scene, {1}, RunEnd::past_peak, never);
  EXPECT_NEAR(found->front().peak_strain, whole->front().peak_strain, 0.02 * whole->front().peak_strain);
}

TEST(SeedRuns, SayWhetherTheyHaveAPeak) {
  mpm::Scene scene = small_scene();
  const auto whole = app::run_seeds(scene, {1}, RunEnd::of_scene, never);
  EXPECT_TRUE(whole->front().peak_reached);
  EXPECT_TRUE(app::run_seeds(scene, {1}, RunEnd::past_peak, never)->front().peak_reached);
  scene.loading.stop_strain = 0.2 * whole->front().peak_strain;
  EXPECT_FALSE(app::run_seeds(scene, {1}, RunEnd::of_scene, never)->front().peak_reached);
}

TEST(SeedRuns, SpreadOverThoseWithAPeak) {
  const std::vector<SeedRun> runs{{1, 3e6, 1e-4, {}, true}, {2, 9e6, 1e-4, {}, false}};
  EXPECT_EQ(app::spread_of_peaks(runs, &SeedRun::peak_stress).mean, 3e6);
  EXPECT_EQ(app::count_without_peak(runs), 1U);
}

TEST(SeedRuns, AreNoneWhenTheyWereStopped) {
  std::atomic<int> asked{0};
  EXPECT_FALSE(
      app::run_seeds(small_scene(), app::seeds_from(1, 4), RunEnd::of_scene, [&] { return ++asked > 10; }));
  EXPECT_LT(asked, 30);
}

TEST(SeedRuns, PassOnWhatWentWrong) {
  mpm::Scene scene = small_scene();
  scene.cfl = 2;
  EXPECT_THROW((void)app::run_seeds(scene, app::seeds_from(1, 4), RunEnd::of_scene, never), mpm::Error);
}

TEST(SeedRuns, HaveStressesBetweenTheirRows) {
  const app::Curve curve{{0, 1, 3}, {0, 10, 30}};
  EXPECT_EQ(app::stress_at(curve, 0), 0);
  EXPECT_EQ(app::stress_at(curve, 0.5), 5);
  EXPECT_EQ(app::stress_at(curve, 2), 20);
  EXPECT_EQ(app::stress_at(curve, 5), 30);
}

TEST(SeedRuns, SpreadRoundTheirMean) {
  const std::vector<SeedRun> runs{{1, 1, 0, {}}, {2, 2, 0, {}}, {3, 3, 0, {}}};
  const app::Spread spread = app::spread_of(runs, &SeedRun::peak_stress);
  EXPECT_DOUBLE_EQ(spread.mean, 2);
  EXPECT_DOUBLE_EQ(spread.deviation, 1);
  EXPECT_EQ(app::spread_of({runs[0]}, &SeedRun::peak_stress).deviation, 0);
}

}  // namespace seed_runs_test
