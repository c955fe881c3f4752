#include "apps/calibrate/trend_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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

double bowl(const std::vector<double>& x) {
  double value = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double from = x[i] - 0.3 * static_cast<double>(i + 1);
    value += from * from;
  }
  return value;
}

TEST(BoundedMinimum, FindsTheBottom) {
  for (const std::size_t n : {1u, 2u, 3u}) {
    const app::Box box{std::vector(n, 0.0), std::vector(n, -2.0), std::vector(n, 2.0)};
    const std::vector<double> x = app::bounded_minimum(box, bowl);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(x[i], 0.3 * static_cast<double>(i + 1), 1e-5);
  }
}

TEST(BoundedMinimum, StopsAtABound) {
  const std::vector<double> x = app::bounded_minimum({{0, 0}, {-2, -2}, {2, 0.25}}, bowl);
  EXPECT_NEAR(x[0], 0.3, 1e-5);
  EXPECT_NEAR(x[1], 0.25, 1e-9);
}

TEST(BoundedMinimum, PassesOnWhatTheFunctionThrows) {
  EXPECT_THROW(
      (void)app::bounded_minimum({{0}, {-1}, {1}},
                                 [](const std::vector<double>&) -> double { throw std::out_of_range("x"); }),
      std::out_of_range);
}

// The four conditions of Penrose (1955), for a full, a deficient and a flat matrix.
TEST(PseudoInverse, KeepsPenrosesConditions) {
  Eigen::MatrixXd full(3, 2), deficient(3, 3), flat(1, 3);
  full << 1, 2, 3, 4, 5, 7;
  deficient << 1, 2, 3, 2, 4, 6, 1, 0, 1;
  flat << 1, -2, 2;
  for (const Eigen::MatrixXd& a : {full, deficient, flat}) {
    const Eigen::MatrixXd b = app::pseudo_inverse(a);
    EXPECT_LT((a * b * a - a).norm(), 1e-12);
    EXPECT_LT((b * a * b - b).norm(), 1e-12);
    EXPECT_LT((a * b - (a * b).transpose()).norm(), 1e-12);
    EXPECT_LT((b * a - (b * a).transpose()).norm(), 1e-12);
  }
}

}  // namespace trend_search_test
