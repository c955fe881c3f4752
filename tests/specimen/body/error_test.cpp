#include "specimen/body/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace specimen {
namespace error_test {

TEST(Error, SaysFieldValueAllowedAndCure) {
  const specimen::Error error("phases.mortar.young", "-20 GPa", "must be > 0",
                              "give the modulus with its unit, e.g. \"20 GPa\"");
  EXPECT_STREQ(error.what(),
               "phases.mortar.young: -20 GPa; must be > 0; give the modulus with its unit, e.g. \"20 GPa\"");
  EXPECT_EQ(error.field, "phases.mortar.young");
}

TEST(Error, LeavesEmptyPartsOut) {
  EXPECT_STREQ(specimen::Error("seed", "-1", "must be >= 0").what(), "seed: -1; must be >= 0");
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Wording, TellsQuantitiesWithTheirUnits) {
  EXPECT_EQ(number(0.5), "0.5");
  EXPECT_EQ(number(-1.0 / 3), "-0.333333");
  EXPECT_EQ(number(not_a_number), "nan");
  EXPECT_EQ(number(-infinite), "-inf");
  EXPECT_EQ(millimetres(0.0125), "12.5 mm");
  EXPECT_EQ(percent(0.45), "45 %");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
}

TEST(Wording, FindsTheNearestName) {
  const std::vector<std::string> names{"fuller", "A8", "A16", "B16"};
  EXPECT_EQ(nearest_name("Fuler", names), "fuller");
  EXPECT_EQ(nearest_name("a16", names), "A16");
  EXPECT_EQ(nearest_name("b61", names), "B16");
  EXPECT_EQ(nearest_name("basalt", names), "");
  EXPECT_EQ(nearest_name("", names), "");
}

}  // namespace error_test
}  // namespace specimen
