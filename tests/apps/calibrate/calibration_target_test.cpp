#include "apps/calibrate/calibration_target.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/text/complaint.hpp"
#include "tests/apps/refusal.hpp"
#include "tests/damaged.hpp"

namespace calibration_target_test {

using app::SeedRun;
using app::Target;

/// Up to a peak and down to nothing.
SeedRun tent(double peak_stress, double peak_strain) {
  return {1, peak_stress, peak_strain, {{0, peak_strain, 2 * peak_strain}, {0, peak_stress, 0}}};
}

Target curve_of(const SeedRun& run) { return {{}, {}, run.curve}; }

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
  for (double& stress : higher.curve.stress) stress *= 1.1;
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

std::string complaint_about(const std::string& text) {
  try {
    (void)app::parse_target_curve(text, "lab.csv");
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::data);
    return rejected.what();
  }
}

TEST(TargetCurve, ReadsUnitsFromTheHeader) {
  const auto curve = app::parse_target_curve(
      "# of the laboratory\nstrain_microstrain, stress_MPa\n0,0\n\n75,1.75\r\n90,0.5\n", "lab.csv");
  EXPECT_EQ(curve.strain, (std::vector{0.0, 75e-6, 90e-6}));
  EXPECT_EQ(curve.stress, (std::vector{0.0, 1.75e6, 0.5e6}));
  EXPECT_EQ(curve.peak_stress(), 1.75e6);
  EXPECT_EQ(curve.peak_strain(), 75e-6);
  EXPECT_EQ(curve.last_strain(), 90e-6);
}

TEST(TargetCurve, ReadsHeadersAsPeopleWriteThem) {
  for (const char* header : {"strain (microstrain),stress (MPa)", "Strain [microstrain], Stress [MPa]",
                             "strain / microstrain,stress / MPa"}) {
    const auto curve = app::parse_target_curve(std::string(header) + "\n0,0\n75,1.75\n90,0.5\n", "lab.csv");
    EXPECT_EQ(curve.strain, (std::vector{0.0, 75e-6, 90e-6})) << header;
    EXPECT_EQ(curve.stress, (std::vector{0.0, 1.75e6, 0.5e6})) << header;
  }
  EXPECT_EQ(app::parse_target_curve("strain (-),stress (kPa)\n0,0\n1e-4,2\n2e-4,1\n", "").stress[1], 2e3);
  EXPECT_EQ(complaint_about("strain,stress (mm)\n"),
            "lab.csv:1:8: stress (mm): needs the unit of a pressure; write a header such as "
            "strain,stress_MPa");
}

TEST(TargetCurve, FindsItsColumnsAmongThoseOfARun) {
  const auto curve = app::parse_target_curve(
      "time_s,strain,stress_Pa,stress_top_Pa\n0,0,0,7\n1,1e-4,5,7\n2,2e-4,3,7\n", "curve.csv");
  EXPECT_EQ(curve.stress, (std::vector{0.0, 5.0, 3.0}));
}

TEST(TargetCurve, LocatesWhatIsNoHeader) {
  const std::string cure = "; write a header such as strain,stress_MPa";
  EXPECT_EQ(complaint_about(""), "lab.csv: no header" + cure);
  EXPECT_EQ(complaint_about("strain,force_N\n"), "lab.csv:1:1: stress: column missing" + cure);
  EXPECT_EQ(complaint_about("stress_MPa,x\n"), "lab.csv:1:1: strain: column missing" + cure);
  EXPECT_EQ(complaint_about("strain,stress\n"), "lab.csv:1:8: stress: needs the unit of a pressure" + cure);
  EXPECT_EQ(complaint_about("strain,stress_mm\n"),
            "lab.csv:1:8: stress_mm: needs the unit of a pressure" + cure);
  EXPECT_EQ(complaint_about("strain,stress_Pa,stress_MPa\n"),
            "lab.csv:1:18: stress_MPa: column given twice; remove one");
}

TEST(TargetCurve, DamagedIsReadOrRefused) {
  const std::string good = "strain_%,stress_MPa,note\n0,0,-\n0.01,2.5e0,-\n0.02,3.0,-\n0.03,1.5,-\n";
  std::size_t refused = 0;
  test::damage_text(good, [&](const std::string& text) {
    refused += test::refusal([&] { (void)app::parse_target_curve(text, "curve.csv"); }) == "nothing" ? 0 : 1;
  });
  EXPECT_GT(refused, 5 * good.size());
}

TEST(TargetCurve, LocatesWhatIsNoRow) {
  const std::string start = "strain,stress_MPa\n0,0\n1e-5,1\n2e-5,2\n";
  EXPECT_EQ(complaint_about(start), "accepted");
  EXPECT_EQ(complaint_about(start + "3e-5\n"), "lab.csv:5:1: row: 1 cells; the header has 2");
  EXPECT_EQ(complaint_about(start + "3e-5,two\n"),
            "lab.csv:5:6: stress: \"two\"; must be a number, its unit is in the header");
  EXPECT_EQ(
      complaint_about(start + "1e-5,2\n"),
      "lab.csv:5:1: strain: 1e-5; must not be below the one before, 0.00002; leave out rows in which the "
      "specimen is unloaded");
  EXPECT_EQ(complaint_about(start + "-3,2\n"),
            "lab.csv:5:1: strain: -3; must lie in [0, 1), positive in the direction of the loading");
}

TEST(TargetCurve, RefusesWhatIsNoCurve) {
  EXPECT_EQ(complaint_about("strain,stress_MPa\n0,0\n1e-5,1\n"), "lab.csv: 2 rows; a curve needs at least 3");
  EXPECT_EQ(complaint_about("strain,stress_MPa\n0,0\n1e-5,-1\n2e-5,-2\n"),
            "lab.csv: stress: nowhere above 0; must be positive in the direction of the loading; turn its "
            "sign");
}

}  // namespace calibration_target_test
