#include "apps/text/quantity.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

#include "apps/text/complaint.hpp"

namespace quantity_test {

using app::Dimension;
using app::format_quantity;
using app::parse_quantity;

constexpr Dimension all_dimensions[] = {Dimension::ratio,    Dimension::length, Dimension::area,
                                        Dimension::pressure, Dimension::angle,  Dimension::velocity,
                                        Dimension::density,  Dimension::time,   Dimension::energy};

/// What the reader says about a text, "allowed; cure"; "accepted" when it has no complaint.
std::string complaint_about(const std::string& text, Dimension dimension) {
  try {
    (void)parse_quantity(text, dimension);
    return "accepted";
  } catch (const app::Mistake& mistake) {
    return mistake.allowed + (mistake.cure.empty() ? "" : "; " + mistake.cure);
  }
}

TEST(ParseQuantity, ReadsEveryUnitAsTheDecimalItIs) {
  // Exact comparisons: a decimal unit must give the very double that the same decimal gives in SI units.
  EXPECT_EQ(parse_quantity("0.5 mm", Dimension::length), 0.5e-3);
  EXPECT_EQ(parse_quantity("0.5mm", Dimension::length), 0.5e-3);
  EXPECT_EQ(parse_quantity(" 15 cm ", Dimension::length), 0.15);
  EXPECT_EQ(parse_quantity("250 um", Dimension::length), 250e-6);
  EXPECT_EQ(parse_quantity("20 GPa", Dimension::pressure), 20e9);
  EXPECT_EQ(parse_quantity("15 N/mm2", Dimension::pressure), 15e6);
  EXPECT_EQ(parse_quantity("0.05 m/s", Dimension::velocity), 0.05);
  EXPECT_EQ(parse_quantity("50 mm/s", Dimension::velocity), 0.05);
  EXPECT_EQ(parse_quantity("2400 kg/m3", Dimension::density), 2400);
  EXPECT_EQ(parse_quantity("2.4 g/cm3", Dimension::density), 2400);
  EXPECT_EQ(parse_quantity("1e-4 s", Dimension::time), 1e-4);
  EXPECT_EQ(parse_quantity("100 us", Dimension::time), 1e-4);
  EXPECT_EQ(parse_quantity("2 mm2", Dimension::area), 2e-6);
  EXPECT_EQ(parse_quantity("60 J/m2", Dimension::energy), 60);
  EXPECT_EQ(parse_quantity("0.06 N/mm", Dimension::energy), 60);
  EXPECT_EQ(parse_quantity("60 N/m", Dimension::energy), 60);
  EXPECT_EQ(parse_quantity("45 %", Dimension::ratio), 0.45);
  EXPECT_EQ(parse_quantity("400 microstrain", Dimension::ratio), 400e-6);
  EXPECT_EQ(parse_quantity("0.45", Dimension::ratio), 0.45);
  EXPECT_EQ(parse_quantity("50 deg", Dimension::angle), 50 * (std::numbers::pi / 180));
  EXPECT_EQ(parse_quantity("0.5 rad", Dimension::angle), 0.5);
}

TEST(ParseQuantity, ReadsSignsPointsAndExponents) {
  EXPECT_EQ(parse_quantity("-.5 mm", Dimension::length), -0.5e-3);
  EXPECT_EQ(parse_quantity("+5. mm", Dimension::length), 5e-3);
  EXPECT_EQ(parse_quantity("5E2 mm", Dimension::length), 0.5);
  EXPECT_EQ(parse_quantity("0 mm", Dimension::length), 0);
  EXPECT_EQ(parse_quantity("1.5 min", Dimension::time), 90);
  EXPECT_EQ(parse_quantity("2h", Dimension::time), 7200);
}

TEST(ParseQuantity, RefusesABareNumberWhereAUnitBelongs) {
  EXPECT_EQ(complaint_about("0.05", Dimension::velocity), "needs a unit; write e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about("0", Dimension::length), "needs a unit; write e.g. \"0.5 mm\"");
}

TEST(ParseQuantity, RefusesUnknownUnitsWithASuggestion) {
  EXPECT_EQ(complaint_about("20 gPa", Dimension::pressure),
            "unknown unit gPa, allowed are MPa, GPa, kPa, Pa and N/mm2; did you mean GPa?");
  EXPECT_EQ(complaint_about("3 furlong", Dimension::time),
            "unknown unit furlong, allowed are s, ms, us, µs, min and h");
}

TEST(ParseQuantity, RefusesTheUnitOfSomethingElse) {
  EXPECT_EQ(complaint_about("5 mm", Dimension::velocity), "must be a velocity, e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about("45 %", Dimension::area), "must be an area, e.g. \"2 mm2\"");
  EXPECT_EQ(complaint_about("5 mm", Dimension::ratio), "must be a number, e.g. 0.45");
}

TEST(ParseQuantity, RefusesWhatIsNoNumber) {
  for (const char* text : {"", "fast", "mm", "-", ".", "e5 mm", "--5 mm", "5 .2 mm", "0x10 mm", "5 5 mm"})
    EXPECT_NE(complaint_about(text, Dimension::length), "accepted") << text;
  EXPECT_EQ(complaint_about("fast", Dimension::velocity), "must be a velocity, e.g. \"0.05 m/s\"");
  EXPECT_EQ(complaint_about("0,5 mm", Dimension::length),
            "must be a length, e.g. \"0.5 mm\"; write the decimals behind a point");
}

TEST(ParseQuantity, RefusesWhatIsNotFiniteOrBeyondDoubles) {
  for (const char* text : {"nan m", "inf m", "-inf m", "NaN", "Infinity m"})
    EXPECT_EQ(complaint_about(text, Dimension::length), "must be a finite number") << text;
  EXPECT_EQ(complaint_about("1e308 GPa", Dimension::pressure), "beyond the range of numbers");
  for (const char* text : {"1e999 m", "-1e400 m", "1e-999 m", "1e99999999999999999999 m"})
    EXPECT_EQ(complaint_about(text, Dimension::length), "beyond the range of numbers") << text;
}

TEST(FormatQuantity, ChoosesAReadableUnit) {
  EXPECT_EQ(format_quantity(0.5e-3, Dimension::length), "0.5 mm");
  EXPECT_EQ(format_quantity(0.15, Dimension::length), "150 mm");
  EXPECT_EQ(format_quantity(2e-6, Dimension::length), "2 um");
  EXPECT_EQ(format_quantity(20e9, Dimension::pressure), "20 GPa");
  EXPECT_EQ(format_quantity(15e6, Dimension::pressure), "15 MPa");
  EXPECT_EQ(format_quantity(150e6, Dimension::pressure), "150 MPa");
  EXPECT_EQ(format_quantity(0.05, Dimension::velocity), "0.05 m/s");
  EXPECT_EQ(format_quantity(2400, Dimension::density), "2400 kg/m3");
  EXPECT_EQ(format_quantity(1e-4, Dimension::time), "0.1 ms");
  EXPECT_EQ(format_quantity(2e-6, Dimension::area), "2 mm2");
  EXPECT_EQ(format_quantity(50 * (std::numbers::pi / 180), Dimension::angle), "50 deg");
  EXPECT_EQ(format_quantity(0, Dimension::length), "0 m");
}

TEST(FormatQuantity, IsReadBackToTheSameDouble) {
  std::mt19937_64 random(7);
  const double extremes[] = {std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::epsilon(),
                             0.1,
                             1.0 / 3,
                             -1e-9};
  for (const Dimension dimension : all_dimensions) {
    for (const double value : extremes)
      EXPECT_EQ(parse_quantity(format_quantity(value, dimension), dimension), value)
          << format_quantity(value, dimension);
    for (int i = 0; i < 2000; ++i) {
      // Any bits at all, but for what is not finite and for subnormals.
      const double value = std::bit_cast<double>(random());
      if (!std::isnormal(value)) continue;
      ASSERT_EQ(parse_quantity(format_quantity(value, dimension), dimension), value)
          << format_quantity(value, dimension);
    }
  }
}

TEST(IsUnit, KnowsItsDimension) {
  EXPECT_TRUE(app::is_unit("mm", Dimension::length));
  EXPECT_FALSE(app::is_unit("mm", Dimension::area));
  EXPECT_FALSE(app::is_unit("", Dimension::length));
}

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

}  // namespace quantity_test
