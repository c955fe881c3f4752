#include "apps/report/reference_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/apps/fake_run.hpp"

namespace reference_curves_test {

using namespace output;
using output::reference_series;
using output::Series;

// Values by hand from the formulas of the codes, six digits.

TEST(ReferenceCurves, GbInTension) {
  EXPECT_NEAR(gb_tension(0.5, 2e6), 0.596875, 1e-9);  // 0.6 - 0.2 / 64
  EXPECT_NEAR(gb_tension(2, 2e6), 2 / 3.248, 1e-9);   // a_t = 0.312 * 4
  EXPECT_NEAR(gb_tension_peak_strain(2e6), 94.5082e-6, 1e-10);
}

TEST(ReferenceCurves, GbInCompression) {
  EXPECT_NEAR(gb_compression_peak_strain(30e6), 1642.083e-6, 1e-9);
  EXPECT_NEAR(gb_compression(0.5, 30e6, 30e9), 0.740293, 1e-6);  // n = 2.557432
  EXPECT_NEAR(gb_compression(2, 30e6, 30e9), 0.594895, 1e-6);    // a_c = 1.361939
}

TEST(ReferenceCurves, EnInCompression) {
  EXPECT_NEAR(en_compression_peak_strain(38e6), 2.161877e-3, 1e-9);
  EXPECT_NEAR(en_compression_peak_strain(120e6), 2.8e-3, 1e-12);  // the upper end
  EXPECT_NEAR(en_young(38e6), 32.83657e9, 1e4);
  EXPECT_NEAR(en_compression(0.5, 38e6), 0.745097, 1e-6);  // k = 1.961528
}

TEST(ReferenceCurves, HordijkSoftensFromOneToNothing) {
  EXPECT_NEAR(hordijk_softening(0), 1, 1e-12);
  EXPECT_NEAR(hordijk_softening(0.2), 0.298613, 1e-6);  // 1.216 exp(-1.386) - 5.6 exp(-6.93)
  EXPECT_NEAR(hordijk_softening(1), 0, 1e-12);
  double area = 0;  // the energy: 1 / 5.136 of strength by last opening
  for (int i = 0; i < 10000; ++i) area += 1e-4 * hordijk_softening((i + 0.5) * 1e-4);
  EXPECT_NEAR(area, 1 / 5.136, 1e-4);
  EXPECT_NEAR(hordijk_last_opening(140, 3e6), 239.68e-6, 1e-9);
}

TEST(ReferenceCurves, ConcreteOfATensileStrength) {
  EXPECT_NEAR(en_compressive_strength(0.3 * std::pow(30, 2.0 / 3) * 1e6), 38e6, 1);
  EXPECT_NEAR(en_compressive_strength(9e6), 58e6, 1e-3);  // the upper end
  EXPECT_NEAR(fib_fracture_energy(38e6), 140.5025, 1e-3);
}

TEST(ReferenceCurves, AllPassThroughOneAtThePeak) {
  EXPECT_NEAR(gb_tension(1, 3e6), 1, 1e-12);
  EXPECT_NEAR(gb_tension(1 + 1e-12, 3e6), 1, 1e-9);
  EXPECT_NEAR(gb_compression(1, 30e6, 30e9), 1, 1e-12);
  EXPECT_NEAR(gb_compression(1 + 1e-12, 30e6, 30e9), 1, 1e-9);
  EXPECT_NEAR(en_compression(1, 38e6), 1, 1e-12);
}

TEST(ReferenceCurves, EnEndsAtTheUltimateStrain) {
  EXPECT_TRUE(std::isfinite(en_compression(1.61, 38e6)));  // 3.48e-3
  EXPECT_TRUE(std::isnan(en_compression(1.63, 38e6)));     // 3.52e-3
}

TEST(ReferenceCurves, GbNeverRisesBehindThePeak) {
  EXPECT_LE(gb_compression(3, 5e6, 20e9), 1);  // a_c would be negative
}

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

}  // namespace reference_curves_test
