#include "apps/report/reference_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/apps/fake_run.hpp"

namespace reference_series_test {

using output::reference_series;
using output::Series;

double highest(const Series& series) { return *std::max_element(series.y.begin(), series.y.end()); }

TEST(ReferenceSeries, OfTensionReachThePeakOfTheRun) {
  const FakeRun run = tension_run(60);
  const auto series = reference_series(run.record());
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].name, "GB 50010");
  EXPECT_EQ(series[1].name, "Hordijk");
  for (const Series& one : series) {
    EXPECT_NEAR(highest(one), 1e-6 * run.result.peak_stress, 0.02e-6 * run.result.peak_stress) << one.name;
    EXPECT_NEAR(one.x.back(), 1e6 * run.result.history.back().strain, 1e-6);
  }
}

// Behind the peak the opening of the crack and the unloading of the rest make up the strain.
TEST(ReferenceSeries, HordijkOpensOneCrackInTheHeight) {
  const FakeRun run = tension_run(60);
  const Series hordijk = reference_series(run.record())[1];
  const double strength = 1e-6 * run.result.peak_stress;
  const double height = run.specimen.mask.height();
  const double last = output::hordijk_last_opening(
      output::fib_fracture_energy(output::en_compressive_strength(1e6 * strength)), 1e6 * strength);
  const double slope = hordijk.y[1] / (1e-6 * hordijk.x[1]);  // [MPa]
  const double opening = (1e-6 * hordijk.x.back() - hordijk.y.back() / slope) * height;
  EXPECT_GT(opening, 0);
  EXPECT_NEAR(hordijk.y.back(), strength * output::hordijk_softening(opening / last), 1e-6);
}

TEST(ReferenceSeries, OfCompressionAreThoseOfBothCodes) {
  const auto series = reference_series(compression_run(60).record());
  ASSERT_FALSE(series.empty());
  EXPECT_EQ(series.back().name, "EN 1992-1-1");
}

TEST(ReferenceSeries, AreNoneWithoutPlatensOrAPeak) {
  EXPECT_TRUE(reference_series(impact_run(60).record()).empty());
  EXPECT_TRUE(reference_series(still_run({"12", "32"}).record()).empty());
}

}  // namespace reference_series_test
