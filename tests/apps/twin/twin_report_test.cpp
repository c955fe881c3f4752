#include "apps/twin/twin_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/apps/small_twins.hpp"

namespace app {
namespace twin_report_test {

const output::Series& named(const output::Chart& chart, const std::string& name) {
  return *std::find_if(chart.series.begin(), chart.series.end(),
                       [&](const output::Series& series) { return series.name == name; });
}

TEST(TwinCharts, ShowTheOriginalBetweenItsTwins) {
  const TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  for (const output::Chart& chart :
       {size_chart(task, twins), aspect_chart(task, twins), direction_chart(task, twins),
        gap_chart(task, twins), s2_chart(task, twins)}) {
    const auto &band = named(chart, "twins, least and largest"), &mean = named(chart, "twins, mean"),
               &original = named(chart, "original");
    ASSERT_EQ(original.x.size(), mean.x.size()) << chart.title;
    ASSERT_EQ(band.x.size(), 2 * mean.x.size() + 1) << chart.title;
    for (std::size_t i = 0; i < mean.y.size(); ++i) {
      EXPECT_LE(band.y[i], mean.y[i] + 1e-12);
      EXPECT_GE(band.y[mean.y.size() + 1 + i], mean.y[i] - 1e-12);
    }
  }
}

TEST(TwinCharts, OfShapesAddUpToTheWholeArea) {
  const TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  for (const output::Chart& chart : {aspect_chart(task, twins), direction_chart(task, twins)}) {
    const output::Series& original = named(chart, "original");
    EXPECT_NEAR(std::accumulate(original.y.begin(), original.y.end(), 0.0), 200,
                1e-9);  // each bar has two corners
  }
  EXPECT_EQ(named(size_chart(task, twins), "original").y.front(), 0);
  EXPECT_EQ(named(size_chart(task, twins), "original").y.back(), 100);
}

TEST(TwinCharts, OfS2BeginWithTheFractionAndShowItsSquare) {
  const TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  const output::Chart chart = s2_chart(task, twins);
  EXPECT_EQ(named(chart, "original").y.front(), task.descriptors.fraction);
  EXPECT_NEAR(named(chart, "original").x.back(), 20, 1e-9);  // mm
  EXPECT_EQ(named(chart, "fraction squared").y.front(),
            task.descriptors.fraction * task.descriptors.fraction);
  const output::Chart axes = s2_along_axes_chart(task, twins);
  ASSERT_EQ(axes.series.size(), 4u);
  EXPECT_EQ(named(axes, "original, along y").y, task.descriptors.s2.along_y);
}

TEST(TwinCharts, OfASingleTwinHaveNoBand) {
  TwinTask task = test::small_task();
  task.count = 1;
  EXPECT_EQ(size_chart(task, test::small_twins(task)).series.size(), 2u);
}

}  // namespace twin_report_test
}  // namespace app
