#include "apps/text/figures.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <string>
#include <vector>

#include "apps/text/words.hpp"

namespace figures_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A comma for a point and dots between thousands, as some countries write.
struct CommaPunct : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Exact, ReadsBackAsTheSameDouble) {
  for (const double value :
       {0.0, -0.0, 0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -2.5e-7, 123456789.0, 1e22})
    EXPECT_EQ(std::strtod(output::exact(value).c_str(), nullptr), value) << value;
}

TEST(Exact, NamesWhatIsNoNumber) {
  EXPECT_EQ(output::exact(std::nan("")), "nan");
  EXPECT_EQ(output::exact(-std::nan("")), "nan");
  EXPECT_EQ(output::exact(infinity), "inf");
  EXPECT_EQ(output::exact(-infinity), "-inf");
}

TEST(Numbers, AreTheSameInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPunct));
  EXPECT_EQ(output::exact(1234567.25), "1234567.25");
  EXPECT_EQ(output::rounded(1234.5, 6), "1234.50");
  EXPECT_EQ(output::percent(0.4513), "45.1\u00A0%");
  std::locale::global(before);
}

TEST(Rounded, KeepsSignificantDigits) {
  EXPECT_EQ(output::rounded(3.4321), "3.43");
  EXPECT_EQ(output::rounded(0.71666), "0.717");
  EXPECT_EQ(output::rounded(143.6), "144");
  EXPECT_EQ(output::rounded(0), "0");
  EXPECT_EQ(output::rounded(36), "36.0");
  EXPECT_EQ(output::rounded(0.0012), "0.00120");
}

TEST(Rounded, CountsDigitsAfterRounding) {
  EXPECT_EQ(output::rounded(9.999), "10.0");
  EXPECT_EQ(output::rounded(0.9996), "1.00");
}

TEST(Rounded, UsesAProperMinusAndSetsThousandsApart) {
  EXPECT_EQ(output::rounded(-12345.6, 6), "\u221212\u202F345.6");
  EXPECT_EQ(output::rounded(1234), "1234");
}

TEST(Rounded, UsesPowersOfTenForTheVeryLargeAndSmall) {
  EXPECT_EQ(output::rounded(1.25e-7), "1.25\u00A0×\u00A010⁻⁷");
  EXPECT_EQ(output::rounded(-3e12, 2), "\u22123.0\u00A0×\u00A010¹²");
}

TEST(Rounded, PutsADashForWhatIsNoNumber) {
  EXPECT_EQ(output::rounded(std::nan("")), "\u2013");
  EXPECT_EQ(output::rounded(infinity), "\u2013");
}

TEST(Trimmed, DropsZerosBehindThePointOnly) {
  EXPECT_EQ(output::concise(0.05), "0.05");
  EXPECT_EQ(output::concise(150), "150");
  EXPECT_EQ(output::concise(1.0), "1");
  EXPECT_EQ(output::concise(1e-5), "1\u00A0×\u00A010⁻⁵");
  EXPECT_EQ(output::concise(1.5e-5), "1.5\u00A0×\u00A010⁻⁵");
  EXPECT_EQ(output::concise(0), "0");
}

TEST(WithDecimals, NeverWritesMinusZero) {
  EXPECT_EQ(output::with_decimals(-0.001, 1), "0.0");
  EXPECT_EQ(output::with_decimals(-0.06, 1), "\u22120.1");
}

TEST(Grouped, BeginsAtFiveDigits) {
  EXPECT_EQ(output::grouped(9999), "9999");
  EXPECT_EQ(output::grouped(92628), "92\u202F628");
  EXPECT_EQ(output::grouped(1234567), "1\u202F234\u202F567");
}

TEST(Listed, ReadsAsASentence) {
  EXPECT_EQ(app::listed(std::vector<std::string>{"a"}, "and"), "a");
  EXPECT_EQ(app::listed(std::vector<std::string>{"a", "b"}, "and"), "a and b");
  EXPECT_EQ(app::listed(std::vector<std::string>{"a", "b", "c"}, "and"), "a, b and c");
}

TEST(StrainText, IsInPercentFromOnePercentOn) {
  EXPECT_EQ(app::strain_text(940.27e-6), "940.3e-6");
  EXPECT_EQ(app::strain_text(0), "0e-6");
  EXPECT_EQ(app::strain_text(0.01), "1 %");
  EXPECT_EQ(app::strain_text(0.023128), "2.313 %");
}

}  // namespace figures_test
