#include "apps/drawing/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ticks_test {

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

}  // namespace ticks_test
