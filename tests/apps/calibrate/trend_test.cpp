#include "apps/calibrate/trend_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trend_test {

app::Evaluation evaluation(double a, double b, double noise = 0) {
  app::Evaluation result;
  result.factors = {a, b};
  result.figures = Eigen::Vector2d(1 + 2 * std::log(a) + noise, 3 + std::log(a) - std::log(b));
  return result;
}

TEST(Trend, IsExactForPowers) {
  const app::Trend trend =
      app::fit_trend({evaluation(1, 1), evaluation(2, 1), evaluation(1, 3)}, Eigen::Vector2d(0.1, 0.2));
  EXPECT_NEAR(trend.slope(0, 0), 2, 1e-12);
  EXPECT_NEAR(trend.slope(0, 1), 0, 1e-12);
  EXPECT_NEAR(trend.slope(1, 0), 1, 1e-12);
  EXPECT_NEAR(trend.slope(1, 1), -1, 1e-12);
  EXPECT_NEAR(trend.at(Eigen::Vector2d(0.5, 0.5))[0], 2, 1e-12);
}

TEST(Trend, WeighsWhatIsNearMost) {
  const std::vector<app::Evaluation> history{evaluation(1, 1), evaluation(1.01, 1), evaluation(1, 1.01),
                                             evaluation(4, 1, 5), evaluation(8, 1, -5)};
  const app::Trend trend = app::fit_trend(history, Eigen::Vector2d::Zero());
  EXPECT_NEAR(trend.at_centre[0], 1, 0.05);
}

TEST(Trend, GivesNoSlopeToWhatWasNotChanged) {
  const app::Trend trend = app::fit_trend({evaluation(1, 1), evaluation(2, 1)}, Eigen::Vector2d::Zero());
  EXPECT_NEAR(trend.slope(1, 1), 0, 1e-12);
  EXPECT_NEAR(trend.slope(1, 0), 1, 1e-12);
}

TEST(Trend, LeavesOutWhatHasNoFigures) {
  const app::Evaluation diverged{{9, 9}, 10, {}, {}, false};
  const app::Trend trend = app::fit_trend({evaluation(1, 1), diverged, evaluation(2, 1), evaluation(1, 2)},
                                          Eigen::Vector2d::Zero());
  EXPECT_NEAR(trend.slope(0, 0), 2, 1e-12);
}

}  // namespace trend_test
