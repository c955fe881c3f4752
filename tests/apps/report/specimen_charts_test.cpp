#include "apps/report/run_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace specimen_charts_test {

specimen::Specimen with_diameters(const std::vector<double>& diameters) {
  specimen::Specimen specimen;
  for (const double d : diameters) {
    specimen::Inclusion inclusion;
    inclusion.equivalent_diameter = d;
    inclusion.area = std::numbers::pi / 4 * d * d;
    specimen.inclusions.push_back(inclusion);
  }
  return specimen;
}

TEST(SpecimenCharts, TheSieveCurveRisesToAHundred) {
  const output::Chart chart = output::sieve_chart(with_diameters({4e-3, 6e-3, 9e-3, 12e-3}));
  ASSERT_EQ(chart.series.size(), 1U);
  const auto& y = chart.series[0].y;
  EXPECT_TRUE(std::is_sorted(y.begin(), y.end()));
  EXPECT_NEAR(y.back(), 100, 1e-9);
  EXPECT_NEAR(chart.series[0].x.back(), 12, 1e-9);
}

TEST(SpecimenCharts, ReferencesRunFromTheSmallestToTheLargest) {
  const auto references = output::sieve_references(with_diameters({4e-3, 6e-3, 9e-3, 12e-3}));
  ASSERT_EQ(references.size(), 5U);
  EXPECT_EQ(references[0].name, "A16");
  for (const output::Series& one : references) {
    EXPECT_TRUE(std::is_sorted(one.x.begin(), one.x.end())) << one.name;
    EXPECT_TRUE(std::is_sorted(one.y.begin(), one.y.end())) << one.name;
    EXPECT_NEAR(one.x.front(), 4, 1e-6) << one.name;
    EXPECT_NEAR(one.x.back(), 12, 1e-6) << one.name;
    EXPECT_NEAR(one.y.front(), 0, 1e-6) << one.name;
    EXPECT_NEAR(one.y.back(), 100, 1e-9) << one.name;
  }
}

TEST(SpecimenCharts, WithoutAggregatesThereIsNoCurve) {
  EXPECT_TRUE(output::sieve_chart(with_diameters({})).series.empty());
  EXPECT_TRUE(output::sieve_references(with_diameters({})).empty());
  EXPECT_TRUE(output::sieve_references(with_diameters({5e-3, 5e-3})).empty());  // of one size
}

}  // namespace specimen_charts_test
