#include "apps/study/study_charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace study_charts_test {

using namespace app;
using output::Chart;
using output::Series;
using testing::ElementsAre;

/// Value of a series at its point nearest to x.
double at(const Series& series, double x) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (std::abs(series.x[i] - x) < std::abs(series.x[nearest] - x)) nearest = i;
  return series.y[nearest];
}

TEST(StudyCharts, HistogramHoldsEveryMember) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  const Chart chart = histogram_chart(values, "Peak", "MPa");
  const Series& steps = chart.series.front();
  double sum = 0;
  for (std::size_t i = 1; i + 1 < steps.x.size(); i += 2) {
    EXPECT_EQ(steps.y[i], steps.y[i + 1]);
    sum += steps.y[i];
  }
  EXPECT_NEAR(sum, 100, 1e-9);
  EXPECT_EQ(steps.x.front(), 1);
  EXPECT_NEAR(steps.x.back(), 100, 1e-6);
  EXPECT_FALSE(histogram_chart({2, 2, 2}, "Peak", "MPa").series.front().x.empty());
}

TEST(StudyCharts, WeibullPaperMakesTheDistributionALine) {
  std::vector<double> values;
  for (int i = 1; i < 40; ++i) values.push_back(3 * std::pow(-std::log1p(-i / 40.0), 0.1));
  const WeibullFit fit = fit_weibull(values);
  const Chart chart = weibull_chart(values, fit, "peak", "MPa");
  ASSERT_EQ(chart.series.size(), 4U);
  EXPECT_TRUE(chart.x.logarithmic);
  const Series &line = chart.series[1], &low = chart.series[2], &high = chart.series[3];
  const double slope = (line.y.back() - line.y.front()) / std::log(line.x.back() / line.x.front());
  EXPECT_NEAR(slope, fit.modulus, 1e-6);
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    EXPECT_LT(low.x[i], line.x[i]);
    EXPECT_GT(high.x[i], line.x[i]);
  }
  EXPECT_TRUE(chart.series[0].dotted);
  EXPECT_NEAR(chart.series[0].y[0], std::log(-std::log1p(-0.5 / 39)), 1e-12);
  EXPECT_EQ(std::count_if(chart.series[0].x.begin(), chart.series[0].x.end(), [](double x) { return x > 0; }),
            39);
}

TEST(StudyCharts, TheMeanSettles) {
  const Chart chart = convergence_chart({4, 6, std::nan(""), 5, 9}, "Peak", "MPa");
  EXPECT_THAT(chart.series[0].x, ElementsAre(3, 4));
  EXPECT_THAT(chart.series[0].y, ElementsAre(5, 6));
  EXPECT_NEAR(chart.series[1].y[0], 5 - 4.302653 / std::sqrt(3),
              1e-5);  // t of 2 degrees of freedom, deviation 1
  EXPECT_NEAR(chart.series[2].y[0], 5 + 4.302653 / std::sqrt(3), 1e-5);
}

TEST(StudyCharts, CurvesHaveMeanAndBand) {
  std::vector<Curve> curves;
  for (int i = 0; i <= 10; ++i) curves.push_back({{0, 1e-4}, {0, 1e6 * i}});
  curves.emplace_back();  // of a member that failed
  const Chart chart = curves_chart({"mean"}, {curves}, "Stress", "Strain");
  ASSERT_EQ(chart.series.size(), 4U);
  EXPECT_EQ(chart.x.unit, "microstrain");
  EXPECT_NEAR(at(chart.series[1], 100), 5, 1e-9);
  EXPECT_NEAR(at(chart.series[2], 100), 1, 1e-9);
  EXPECT_NEAR(at(chart.series[3], 100), 9, 1e-9);
  EXPECT_EQ(curves_chart({"a", "b"}, {curves, curves}, "Stress", "Strain").series.size(), 3U);
  const Chart many = curves_chart({"mean"}, {std::vector<Curve>(500, curves[3])}, "Stress", "Strain");
  EXPECT_EQ(many.series[0].name, "200 of 500 members");
  EXPECT_EQ(
      std::count_if(many.series[0].x.begin(), many.series[0].x.end(), [](double x) { return std::isnan(x); }),
      199);  // gaps between 200 lines
}

TEST(StudyCharts, CracksAreSharesOfTheMembers) {
  specimen::LabelledMask mask;
  mask.pixel_size = 1e-3;
  mask.labels = {2, 3};
  CrackCount cracks;
  cracks.failures = mpm::PixelField<int>::Zero(2, 3);
  cracks.failures(0, 1) = 4;
  cracks.failures(1, 2) = 2;
  cracks.members = 4;
  const output::Drawing drawing = crack_drawing(cracks, mask);
  const auto& picture = std::get<output::Pixels>(drawing.shapes.front()).picture;
  const int factor = picture.rows / 2;
  const auto colour = [&](int row, int col) {
    const specimen::Rgb rgb = picture(row * factor, col * factor);
    return std::array{rgb.r, rgb.g, rgb.b};
  };
  EXPECT_EQ(colour(0, 0), colour(1, 1));
  EXPECT_NE(colour(0, 0), colour(0, 1));
  EXPECT_NE(colour(0, 1), colour(1, 2));
}

TEST(StudyCharts, SizesStandOnLogarithmicAxes) {
  const Chart chart = size_chart({0.1, 0.2}, {3e6, 2e6}, {4e6, 0.1, 0.9, false});
  EXPECT_TRUE(chart.x.logarithmic);
  EXPECT_TRUE(chart.y.logarithmic);
  EXPECT_EQ(chart.series[0].x[0], 100);
  EXPECT_NEAR(chart.series[1].y.front(), 4 / std::sqrt(2), 1e-9);
}

}  // namespace study_charts_test
