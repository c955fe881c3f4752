#include "apps/calibrate/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/calibrate/calibration_report.hpp"
#include "apps/job/job.hpp"
#include "tests/apps/small_specimen.hpp"

namespace calibration_test {

using app::Calibration;
using app::CalibrationTask;
using app::SeedRun;
using app::Settings;

bool never() { return false; }

/// Runs of the small specimen with strengths and moduli scaled.
std::vector<SeedRun> runs_of(double strengths, double moduli, int seeds) {
  Settings settings = test::small_settings();
  for (mpm::Phase& phase : settings.phases) {
    phase.tensile_scale *= strengths;
    phase.young *= moduli;
  }
  const mpm::Scene scene = app::build_scene(test::small_specimen(), settings);
  return *app::run_seeds(scene, app::seeds_from(1, seeds), app::RunEnd::of_scene, never);
}

class CalibrationOfSmall : public testing::Test {
 protected:
  CalibrationTask task(const app::Target& target, const std::string& free) const {
    const Settings settings = test::small_settings();
    CalibrationTask task{settings, specimen_, target,
                         app::parse_free(free, settings, app::build_scene(specimen_, settings))};
    task.seeds = 3;
    task.further_seeds = 2;
    return task;
  }

  /// The same with the cell and without the damping of the paper.
  CalibrationTask undamped_task(const app::Target& target, const std::string& free) const {
    CalibrationTask task = this->task(target, free);
    task.settings.scene.pixel_cells = false;
    task.settings.scene.points_per_cell = 2;
    task.settings.scene.local_damping = 0;
    return task;
  }

  specimen::Specimen specimen_ = test::small_specimen();
};

TEST_F(CalibrationOfSmall, TellsWhatALongSearchTakes) {
  CalibrationTask task = this->task({2e6, {}, {}}, "tensile_scale");
  EXPECT_EQ(announcement(task), "");
  task.settings.scene.loading.velocity = 1e-8;
  EXPECT_THAT(
      announcement(task),
      testing::ContainsRegex("^each set of parameters takes about .* here: 3 runs of [0-9]+ points and "
                             "[0-9]+ steps, [0-9]+ at a time; at most 100 sets are tried$"));
}

TEST_F(CalibrationOfSmall, RecoversWhatAPeakWasMadeWith) {
  const app::Peak peak = app::mean_peak(runs_of(0.6, 1.3, 3));
  const CalibrationTask wanted = task({peak.stress, peak.strain, {}}, "tensile_scale,young");
  const Calibration found = app::calibrate(wanted, never);
  ASSERT_FALSE(found.history.empty());
  EXPECT_LE(found.misfit, 0.01);
  EXPECT_NEAR(found.best_evaluation().factors[0], 0.6, 0.02);
  EXPECT_NEAR(found.best_evaluation().factors[1], 1.3, 0.05);
  EXPECT_EQ(app::why_not_met(wanted, found), "");
  EXPECT_EQ(found.runs.size(), 3u);
  EXPECT_EQ(found.further_runs.size(), 2u);
  EXPECT_EQ(found.further_runs.front().seed, 4u);
}

TEST_F(CalibrationOfSmall, SettingsThatWereFoundGiveTheRunsThatWereFound) {
  const Calibration found = app::calibrate(task({1.5e6, {}, {}}, "tensile_scale"), never);
  const mpm::Scene scene = app::build_scene(specimen_, found.settings);
  const auto again = app::run_seeds(scene, {1}, app::RunEnd::of_scene, never);
  EXPECT_EQ(again->front().peak_stress, found.runs.front().peak_stress);
  EXPECT_EQ(again->front().curve.stress, found.runs.front().curve.stress);
  EXPECT_NEAR(app::mean_peak(found.runs).stress, 1.5e6, 0.02 * 1.5e6);
  EXPECT_EQ(found.settings.phases[2].tensile_scale, 9e6);  // of the ITZ, which the specimen has not
}

TEST_F(CalibrationOfSmall, RunsOfTheResultGoPastAPeakBeyondTheScene) {
  const app::Peak peak = app::mean_peak(runs_of(1, 1, 3));
  CalibrationTask wanted = task({3 * peak.stress, {}, {}}, "tensile_scale");
  wanted.settings.scene.loading.stop_strain = 2 * peak.strain;
  const Calibration found = app::calibrate(wanted, never);
  EXPECT_NEAR(app::mean_peak(found.runs).stress, 3 * peak.stress, 0.1 * peak.stress);
  for (const SeedRun& run : found.runs) EXPECT_LT(1.2 * run.peak_strain, run.curve.last_strain());
}

TEST_F(CalibrationOfSmall, ComesCloseToACurve) {
  const SeedRun measured = runs_of(0.6, 1.3, 1).front();
  CalibrationTask wanted = task({{}, {}, measured.curve}, "tensile_scale,young");
  wanted.seeds = 1;
  wanted.evaluations = 12;
  const Calibration found = app::calibrate(wanted, never);
  EXPECT_LT(found.misfit, 0.1);
  EXPECT_NEAR(found.best_evaluation().factors[0], 0.6, 0.05);
  EXPECT_NEAR(found.best_evaluation().factors[1], 1.3, 0.1);
  EXPECT_FALSE(found.best_evaluation().coarse);
  EXPECT_TRUE(found.history.front().coarse);
}

TEST_F(CalibrationOfSmall, SaysWhichBoundKeepsATargetOutOfReach) {
  const CalibrationTask wanted = task({1e6, {}, {}}, "mortar.tensile_scale=12 MPa..20 MPa");
  const Calibration found = app::calibrate(wanted, never);
  const std::string why = app::why_not_met(wanted, found);
  EXPECT_EQ(why.rfind("the target, a peak of 1 MPa, was not met; the nearest is a peak of ", 0), 0u) << why;
  const std::string end = "; phases.mortar.tensile_scale at its lower bound of 12 MPa";
  ASSERT_GT(why.size(), end.size());
  EXPECT_EQ(why.substr(why.size() - end.size()), end);
}

TEST_F(CalibrationOfSmall, SaysWhenItsParametersCannotReachTheTarget) {
  const CalibrationTask wanted = undamped_task({1e6, {}, {}}, "mortar.density");
  const std::string why = app::why_not_met(wanted, app::calibrate(wanted, never));
  EXPECT_NE(why.find("; these parameters alone do not reach it; free others"), std::string::npos) << why;
}

TEST_F(CalibrationOfSmall, KeepsTheBestSoFarWhenInterrupted) {
  int told = 0;
  const CalibrationTask wanted = task({1e6, {}, {}}, "tensile_scale");
  const Calibration found = app::calibrate(
      wanted, [&] { return told >= 2; },
      [&](const Calibration& so_far) {
        ++told;
        EXPECT_EQ(so_far.history.size(), static_cast<std::size_t>(told));
      });
  EXPECT_EQ(found.end, app::SearchEnd::stopped);
  EXPECT_EQ(found.history.size(), 2u);
  EXPECT_EQ(found.runs.size(), 3u);
  EXPECT_TRUE(found.further_runs.empty());
  EXPECT_LT(found.settings.phases[1].tensile_scale, 15e6);  // the step down came closer
}

TEST_F(CalibrationOfSmall, PassesOverParametersThatMakeNoValidScene) {
  CalibrationTask wanted = task({1.5e6, {}, {}}, "tensile_scale,mortar.poisson");
  wanted.parameters[1].low = 2;        // 0.4 and more
  wanted.parameters[1].high = 2.4999;  // where plane strain has no stiffness
  const Calibration found = app::calibrate(wanted, never);
  EXPECT_LT(found.misfit, 0.05);
}

TEST_F(CalibrationOfSmall, ReportsWhatDiverges) {
  // A pixel alone in its cell, beside a block of mortar, bears no such step.
  specimen::Raster<std::uint8_t>& labels = specimen_.mask.labels;
  for (int row = 0; row < 12; ++row)
    for (int col = 6; col < 12; ++col) labels(row, col) = specimen::phase::void_;
  labels(2, 7) = specimen::phase::aggregate;
  CalibrationTask wanted = undamped_task({1e6, {}, {}}, "tensile_scale");
  wanted.settings.scene.cfl = 1;
  for (mpm::Phase& phase : wanted.settings.phases) phase.poisson = 0.4999;
  EXPECT_THROW((void)app::calibrate(wanted, never), app::Rejected);
}

/// Peak stress as the square of the one parameter.
app::Evaluation evaluation(double factor) {
  const double stress = 1e6 * factor * factor;
  return {{factor}, 0.1, {stress, 1e-4}, app::Figures::Constant(1, std::log(stress)), false};
}

SeedRun run_with(double stress) { return {1, stress, 1e-4, {}}; }

Calibration found() {
  Calibration result;
  result.history = {evaluation(1), evaluation(1.2), evaluation(0.9)};
  const double up = std::exp(0.1);
  result.runs = {run_with(1e6 * up), run_with(1e6 / up)};
  result.further_runs = {run_with(1e6 * up), run_with(1e6 / up)};
  return result;
}

TEST(ParameterSpread, IsThatOfThePeakOverItsSlope) {
  const specimen::Specimen none;
  CalibrationTask task{{}, none, {1e6, {}, {}}, {{}}};
  task.seeds = 4;
  const auto spread = app::parameter_spread(task, found());
  ASSERT_TRUE(spread);
  ASSERT_EQ(spread->size(), 1u);
  const double of_peak = 0.1 * std::sqrt(4.0 / 3);
  EXPECT_NEAR(spread->front(), of_peak / 2 / std::sqrt(4.0), 1e-6);
}

TEST(ParameterSpread, IsUnknownWhereItCannotBeTold) {
  const specimen::Specimen none;
  const CalibrationTask one_figure{{}, none, {1e6, {}, {}}, {{}, {}}};
  EXPECT_FALSE(app::parameter_spread(one_figure, found()));
  const CalibrationTask curve{{}, none, {{}, {}, {{0, 1e-4, 2e-4}, {0, 1e6, 0}}}, {{}}};
  EXPECT_FALSE(app::parameter_spread(curve, found()));
  Calibration few = found();
  few.further_runs.clear();
  EXPECT_FALSE(app::parameter_spread({{}, none, {1e6, {}, {}}, {{}}}, few));
}

}  // namespace calibration_test
