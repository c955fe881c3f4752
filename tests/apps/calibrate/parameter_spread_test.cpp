#include "apps/calibrate/calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace parameter_spread_test {

using app::Calibration;
using app::CalibrationTask;
using app::SeedRun;

/// Peak stress as the square of the one parameter.
app::Evaluation evaluation(double factor) {
  const double stress = 1e6 * factor * factor;
  return {{factor}, 0.1, {stress, 1e-4}, app::Figures::Constant(1, std::log(stress)), false};
}

SeedRun run_with(double stress) { return {1, stress, 1e-4, {}, {}}; }

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

}  // namespace parameter_spread_test
