#include "apps/drawing/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ticks_test {

using output::Place;
using output::strain_unit;
using testing::ElementsAre;

TEST(Ticks, AreRoundMultiplesWithinTheRange) {
  EXPECT_THAT(output::ticks_between(0, 3.9, 8).values, ElementsAre(0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5));
  EXPECT_THAT(output::ticks_between(0, 403, 6).values, ElementsAre(0, 100, 200, 300, 400));
  EXPECT_THAT(output::ticks_between(-25, 50, 5).values, ElementsAre(-20, 0, 20, 40));
}

TEST(Ticks, StayFewAndInsideForAnyRange) {
  for (double high = 1e-9; high < 1e12; high *= 1.7)
    for (const int at_most : {2, 5, 12}) {
      const output::Ticks ticks = output::ticks_between(-0.3 * high, high, at_most);
      EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(at_most)) << high;
      EXPECT_GE(ticks.values.size(), 1U) << high;
      EXPECT_GE(ticks.values.front(), -0.3001 * high);
      EXPECT_LE(ticks.values.back(), 1.0001 * high);
    }
}

TEST(Ticks, IncludeAnEndThatIsRound) {
  EXPECT_DOUBLE_EQ(output::ticks_between(0, 0.3, 4).values.back(), 0.3);  // 3 * 0.1 > 0.3 in binary
}

TEST(LogarithmicTicks, ArePowersOfTenOrTwoAndFiveTimesThem) {
  EXPECT_THAT(output::logarithmic_ticks(0.5, 2000, 8), ElementsAre(1, 10, 100, 1000));
  EXPECT_THAT(output::logarithmic_ticks(0.3, 8, 8), ElementsAre(0.5, 1, 2, 5));
  EXPECT_THAT(output::logarithmic_ticks(1, 10, 8), ElementsAre(1, 10));
  EXPECT_THAT(output::logarithmic_ticks(2.2, 4, 4), ElementsAre(2.5, 3, 3.5, 4));  // too few of them
}

TEST(LogarithmicTicks, StayFewAndInside) {
  for (double high = 1e-12; high < 1e9; high *= 3.3)
    for (const double decades : {0.2, 1.7, 5.0, 14.0}) {
      const double low = high / std::pow(10, decades);
      const auto ticks = output::logarithmic_ticks(low, high, 6);
      EXPECT_GE(ticks.size(), 1U);
      EXPECT_LE(ticks.size(), 7U);
      EXPECT_GE(ticks.front(), low * 0.999);
      EXPECT_LE(ticks.back(), high * 1.001);
    }
}

TEST(TickText, HasTheDecimalsOfTheStep) {
  EXPECT_EQ(output::tick_text(0.5, 0.5), "0.5");
  EXPECT_EQ(output::tick_text(2, 0.5), "2.0");
  EXPECT_EQ(output::tick_text(0, 0.5), "0");
  EXPECT_EQ(output::tick_text(100, 100), "100");
  EXPECT_EQ(output::tick_text(20000, 5000), "20\u202F000");
  EXPECT_EQ(output::tick_text(-0.02, 0.02), "\u22120.02");
}

TEST(TickText, UsesPowersOfTenWhereThatIsShorter) {
  EXPECT_EQ(output::tick_text(3e-7, 1e-7), "3\u00A0×\u00A010⁻⁷");
  EXPECT_EQ(output::tick_text(1.2e-6, 1e-7), "1.2\u00A0×\u00A010⁻⁶");
  EXPECT_EQ(output::tick_text(3e9, 1e9), "3\u00A0×\u00A010⁹");
}

TEST(StrainUnit, IsPercentFromOnePercentOn) {
  EXPECT_EQ(strain_unit(0.00999).name, "microstrain");
  EXPECT_EQ(strain_unit(0.00999).per_strain, 1e6);
  EXPECT_EQ(strain_unit(0.01).name, "%");
  EXPECT_EQ(strain_unit(0.01).per_strain, 100);
}

TEST(StrainUnit, OfARunIsThatOfItsLargestStrain) {
  mpm::Result result;
  EXPECT_EQ(strain_unit(result).name, "microstrain");
  result.history.resize(3);
  result.history[1].strain = 0.05;
  result.history[2].strain = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(strain_unit(result).name, "%");
}

/// Pulled to 1 MPa and then to a lower stress.
mpm::Result run_that_falls_to(double stress) {
  mpm::Result result;
  result.peak_stress = 1e6;
  result.peak_strain = 118.4e-6;
  result.history.push_back({.strain = 118.4e-6, .stress = 1e6});
  result.history.push_back({.strain = 200e-6, .stress = stress});
  return result;
}

TEST(StrainWords, CallNoStrainThatOfAPeakThatIsNone) {
  EXPECT_EQ(output::strain_words(run_that_falls_to(0.97e6), 118e-6, 0),
            "118 microstrain, 100\u00A0% of the strain at the largest stress, which is no peak");
}

TEST(StrainWords, NameTheShareOfThePeakWhereThereIsOne) {
  mpm::Result result;
  EXPECT_EQ(output::strain_words(result, 118e-6, 1), "118 microstrain");
  result = run_that_falls_to(0.5e6);
  EXPECT_EQ(output::strain_words(result, 118e-6, 0), "118 microstrain, 100\u00A0% of the peak strain");
  EXPECT_EQ(output::strain_words(result, 118e-6, 1), "118 microstrain, 99.7\u00A0% of the peak strain");
}

TEST(UnbrokenLines, StopWhereAValueIsNoNumber) {
  const double gap = std::nan("");
  const auto lines = output::unbroken_lines({0, 1, 2, 3, 4, 5, 6}, {0, 1, gap, 3, gap, 5, 6});
  ASSERT_EQ(lines.size(), 2U);  // the point at 3 stands alone
  EXPECT_EQ(lines[0].size(), 2U);
  EXPECT_EQ(lines[1].front().x, 5);
}

TEST(UnbrokenLines, AreNoneForNoPoints) { EXPECT_TRUE(output::unbroken_lines({}, {}).empty()); }

TEST(ThinLine, LeavesAShortLineAsItIs) {
  const std::vector<Place> line{{0, 0}, {10, 5}, {20, 0}};
  EXPECT_EQ(output::thin_line(line).size(), 3U);
}

TEST(ThinLine, KeepsEndsAndExtremesInOrder) {
  std::vector<Place> line;
  for (int i = 0; i < 100000; ++i) line.push_back({i / 1000.0, 50 + 40 * std::sin(0.37 * i)});
  line[54321].y = -1000;  // a spike one sample wide
  const std::vector<Place> thin = output::thin_line(line);
  EXPECT_LE(thin.size(), 4U * 200);
  EXPECT_EQ(thin.front().x, line.front().x);
  EXPECT_EQ(thin.back().x, line.back().x);
  EXPECT_TRUE(std::is_sorted(thin.begin(), thin.end(), [](Place a, Place b) { return a.x < b.x; }));
  EXPECT_TRUE(std::any_of(thin.begin(), thin.end(), [](Place p) { return p.y == -1000; }));
}

}  // namespace ticks_test
