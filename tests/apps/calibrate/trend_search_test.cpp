#include "apps/calibrate/trend_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trend_search_test {

using app::SearchEnd;

/// A peak that follows powers of two parameters, with jumps of `noise` from one set to the next.
class FakePeak {
 public:
  explicit FakePeak(double noise = 0) : noise_(noise) {}

  std::optional<app::Evaluation> operator()(const std::vector<double>& x) {
    if (++count_ > stop_after_) return std::nullopt;
    app::Evaluation evaluation;
    for (const double logarithm : x) evaluation.factors.push_back(std::exp(logarithm));
    evaluation.figures = Eigen::Vector2d(1 + x[0] + noise_ * std::sin(1e4 * x[0]),
                                         2 + x[0] - x[1] + noise_ * std::sin(3e4 * (x[0] + x[1])));
    evaluation.misfit = std::sqrt(app::mean_square(evaluation.figures, wanted));
    last_ = x;
    least_ = std::min(least_, evaluation.misfit);
    return evaluation;
  }

  app::Figures wanted = Eigen::Vector2d(0.4, 1.6);  // at -0.6, -0.2
  int stop_after_ = 1000;
  int count_ = 0;
  double least_ = 1e9;
  std::vector<double> last_;

 private:
  double noise_;
};

SearchEnd search(FakePeak& peak, app::TrendPlan plan = {{0, 0}, {-3, -3}, {3, 3}, 0.25, 1e-3, 100}) {
  return app::search_along_trend(plan, peak.wanted, [&](const std::vector<double>& x) { return peak(x); });
}

TEST(TrendSearch, IsThereAtOnceWherePowersHold) {
  FakePeak peak;
  EXPECT_EQ(search(peak), SearchEnd::goal);
  EXPECT_EQ(peak.count_, 4);
  EXPECT_NEAR(peak.last_[0], -0.6, 1e-3);
  EXPECT_NEAR(peak.last_[1], -0.2, 1e-3);
}

TEST(TrendSearch, IsNotCaughtByNoise) {
  FakePeak peak(0.03);
  search(peak);
  EXPECT_LT(peak.count_, 40);
  EXPECT_LT(peak.least_, 0.03);
  EXPECT_NEAR(peak.last_[0], -0.6, 0.05);
  EXPECT_NEAR(peak.last_[1], -0.2, 0.05);
}

TEST(TrendSearch, StaysWithinItsBounds) {
  FakePeak peak;
  EXPECT_EQ(search(peak, {{0, 0}, {-0.5, -3}, {3, 3}, 0.25, 1e-3, 100}), SearchEnd::no_progress);
  EXPECT_GE(peak.last_[0], -0.5);
  EXPECT_NEAR(peak.least_, std::sqrt(0.1 * 0.1 / 2), 1e-3);  // the other figure is met
}

TEST(TrendSearch, EndsAfterAsManyEvaluationsAsItMayMake) {
  FakePeak peak(0.3);
  EXPECT_EQ(search(peak, {{0, 0}, {-3, -3}, {3, 3}, 0.25, 1e-9, 5}), SearchEnd::evaluations);
  EXPECT_EQ(peak.count_, 5);
}

TEST(TrendSearch, EndsWhenItIsStopped) {
  FakePeak peak;
  peak.stop_after_ = 2;
  EXPECT_EQ(search(peak), SearchEnd::stopped);
}

}  // namespace trend_search_test
