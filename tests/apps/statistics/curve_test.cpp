#include "apps/statistics/curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/triangle.hpp"

namespace curve_test {

using namespace app;
using testing::DoubleNear;
using testing::ElementsAre;

TEST(Curve, NormalisedHasItsPeakAtOne) {
  const Curve curve = normalised(test::triangle(3.5e6, 150e-6));
  EXPECT_DOUBLE_EQ(curve.strain.front(), 0);
  EXPECT_NEAR(value_at(curve, 1), 1, 1e-12);
  EXPECT_NEAR(value_at(curve, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(value_at(curve, 1.5), 0.5, 1e-12);
  EXPECT_NEAR(curve.strain.back(), 3, 1e-12);
}

TEST(Curve, HasAPeakOnceItHasFallenAgain) {
  EXPECT_TRUE((Curve{{0, 1, 2}, {0, 1e6, 0.9e6}}).has_peak());
  EXPECT_FALSE((Curve{{0, 1, 2}, {0, 1e6, 0.97e6}}).has_peak());
  EXPECT_FALSE((Curve{{0, 1, 2}, {0, 1e6, 2e6}}).has_peak());
  EXPECT_FALSE((Curve{{0, 1}, {0, -1}}).has_peak()) << "it never rose";
}

TEST(Curve, ThatSnapsBackIsSeenByPlatensThatNeverDo) {
  mpm::Result result;
  for (const auto& [strain, stress] : std::vector<std::pair<double, double>>{
           {0, 0}, {2, 4}, {1, 1}, {1.5, 1.2}, {2.5, 2}, {2.2, 0.5}, {3, 0.1}}) {
    mpm::HistoryRow row;
    row.strain = strain;
    row.stress = stress;
    result.history.push_back(row);
  }
  result.peak_stress = 4;
  result.peak_strain = 2;
  const Curve curve = app::stress_curve(result);
  EXPECT_THAT(curve.strain, ElementsAre(0, 2, 2.5, 3));
  EXPECT_THAT(curve.stress, ElementsAre(0, 4, 2, 0.1));
  EXPECT_DOUBLE_EQ(app::drop_ratio(result, 0.5), 1);
  EXPECT_DOUBLE_EQ(app::drop_ratio(result, 0.2), 1.25);
}

TEST(Curve, ValueIsOnTheLineBetweenPoints) {
  const Curve curve{{1, 3}, {10, 20}};
  EXPECT_DOUBLE_EQ(value_at(curve, 1), 10);
  EXPECT_DOUBLE_EQ(value_at(curve, 1.5), 12.5);
  EXPECT_DOUBLE_EQ(value_at(curve, 3), 20);
  EXPECT_TRUE(std::isnan(value_at(curve, 0.9)));
  EXPECT_TRUE(std::isnan(value_at(curve, 3.1)));
}

TEST(Curve, AxisIsEven) { EXPECT_THAT(even_axis(2, 5), ElementsAre(0, 0.5, 1, 1.5, 2)); }

TEST(Curve, BandHoldsMeanAndEnds) {
  const CurveBand band = band_of({{{0, 2}, {0, 2}}, {{0, 2}, {0, 6}}, {{0, 1}, {0, 2}}}, {0, 1, 2});
  EXPECT_THAT(std::vector(band.mean.begin(), band.mean.begin() + 2), ElementsAre(0, DoubleNear(2, 1e-12)));
  EXPECT_DOUBLE_EQ(band.low[1], 1);
  EXPECT_DOUBLE_EQ(band.high[1], 3);
  EXPECT_TRUE(std::isnan(band.mean[2]));  // the third curve ends before
  EXPECT_TRUE(std::isnan(band.low[2]));
  EXPECT_TRUE(std::isnan(band.high[2]));
}

TEST(Curve, BandMayLeaveOutTheEnds) {
  std::vector<Curve> curves;
  for (int i = 0; i <= 10; ++i) curves.push_back({{0, 1}, {0, 10.0 * i}});
  const CurveBand band = band_of(curves, {1}, 0.1);
  EXPECT_DOUBLE_EQ(band.low[0], 10);
  EXPECT_DOUBLE_EQ(band.high[0], 90);
  EXPECT_DOUBLE_EQ(band.mean[0], 50);
}

TEST(Curve, DistanceIsTheMeanAmount) {
  CurveBand band;
  band.x = {0, 1, 2};
  band.mean = {0, 2, std::nan("")};
  const auto reference = [](double x) { return 3 * x; };
  EXPECT_DOUBLE_EQ(mean_distance(band, reference, 0, 2), 0.5);
  EXPECT_DOUBLE_EQ(mean_distance(band, reference, 0.5, 2), 1);
  EXPECT_TRUE(std::isnan(mean_distance(band, reference, 2, 3)));
}

TEST(Curve, DropIsWhereHalfThePeakIsLost) {
  EXPECT_NEAR(drop_ratio(test::triangle(1e6, 1e-4, 2), 0.5), 1.5, 0.011);  // one row of the history
  EXPECT_NEAR(drop_ratio(test::triangle(1e6, 1e-4, 1.2), 0.5), 1.1, 0.011);
  mpm::Result unbroken = test::triangle(1e6, 1e-4);
  unbroken.history.resize(110);
  EXPECT_TRUE(std::isnan(drop_ratio(unbroken, 0.5)));
}

}  // namespace curve_test
