#include "apps/calibrate/calibration_target.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace calibration_target_test {

using app::SeedRun;
using app::Target;

/// Up to a peak and down to nothing.
SeedRun tent(double peak_stress, double peak_strain) {
  return {1, peak_stress, peak_strain, {0, peak_strain, 2 * peak_strain}, {0, peak_stress, 0}};
}

Target curve_of(const SeedRun& run) { return {{}, {}, {run.strain, run.stress}}; }

TEST(CalibrationTarget, MisfitOfAPeakIsItsRelativeError) {
  const std::vector<SeedRun> runs{tent(1e6, 1e-4), tent(3e6, 3e-4)};
  EXPECT_NEAR(app::misfit({2e6, {}, {}}, runs), 0, 1e-12);
  EXPECT_NEAR(app::misfit({2.02e6, {}, {}}, runs), 0.01, 1e-4);
  EXPECT_NEAR(app::misfit({2.02e6, 2e-4, {}}, runs), 0.01 / std::sqrt(2), 1e-4);
  EXPECT_NEAR(app::misfit({{}, 2.02e-4, {}}, runs), 0.01, 1e-4);
}

TEST(CalibrationTarget, MisfitOfACurveIsThatOfStressesOverItsPeak) {
  const SeedRun run = tent(2e6, 1e-4);
  EXPECT_NEAR(app::misfit(curve_of(run), {run}), 0, 1e-12);
  SeedRun higher = run;
  for (double& stress : higher.stress) stress *= 1.1;
  higher.peak_stress *= 1.1;
  EXPECT_NEAR(app::misfit(curve_of(run), {higher}), 0.1 / std::sqrt(3), 1e-4);
}

TEST(CalibrationTarget, MeanCurveKeepsItsPeakWherePeaksLieApart) {
  const std::vector<SeedRun> runs{tent(1e6, 1e-4), tent(3e6, 3e-4)};
  EXPECT_NEAR(app::mean_stress_at(runs, 2e-4), 2e6, 1e-3);
  EXPECT_NEAR(app::mean_stress_at(runs, 1e-4), 1e6, 1e-3);
  EXPECT_NEAR(app::misfit(curve_of(tent(2e6, 2e-4)), runs), 0, 1e-9);
}

TEST(CalibrationTarget, CurveIsAimedAtByItsPeakFirst) {
  const Target peak = curve_of(tent(2e6, 1e-4)).peak_of_curve();
  EXPECT_EQ(peak.peak_stress, 2e6);
  EXPECT_EQ(peak.peak_strain, 1e-4);
  EXPECT_TRUE(peak.curve.empty());
}

TEST(CalibrationTarget, ScenesReachTheEndOfACurve) {
  mpm::Scene scene;
  scene.loading.stop_strain = 1e-4;
  scene.loading.stop_drop = 0.2;
  scene.history_rows = 1000;
  EXPECT_EQ(app::scene_for({1e6, {}, {}}, scene).loading.stop_strain, 1e-4);
  const mpm::Scene longer = app::scene_for(curve_of(tent(2e6, 2e-4)), scene);
  EXPECT_NEAR(longer.loading.stop_strain, 4.8e-4, 1e-12);
  EXPECT_FALSE(longer.loading.stop_drop);
  EXPECT_EQ(longer.history_rows, 4800);
}

}  // namespace calibration_target_test
