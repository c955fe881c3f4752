#include "apps/text/quantity.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>

namespace number_text_test {

TEST(FormatNumber, IsPlainWhereItIsShort) {
  EXPECT_EQ(app::format_number(0.0004), "0.0004");
  EXPECT_EQ(app::format_number(0.45), "0.45");
  EXPECT_EQ(app::format_number(149e-6), "0.000149");
  EXPECT_EQ(app::format_number(2e-7), "2e-7");
  EXPECT_EQ(app::format_number(-12.5), "-12.5");
  EXPECT_EQ(app::format_number(1e300), "1e300");
  EXPECT_EQ(app::format_number(2), "2");
}

TEST(FormatNumber, IsReadBackToTheSameDouble) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 5000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(std::strtod(app::format_number(value).c_str(), nullptr), value) << app::format_number(value);
  }
}

TEST(FormatNumber, NamesWhatIsNotFinite) {
  EXPECT_EQ(app::format_number(std::nan("")), "nan");
  EXPECT_EQ(app::format_number(-HUGE_VAL), "-inf");
}

TEST(FormatShifted, MovesThePointAndKeepsTheDigits) {
  EXPECT_EQ(app::format_shifted(0.1 + 0.2, 3), "300.00000000000004");
  EXPECT_EQ(app::format_shifted(20e9, -9), "20");
  EXPECT_EQ(app::format_shifted(0, 3), "0");
}

}  // namespace number_text_test
