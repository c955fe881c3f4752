#include "specimen/body/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace specimen {
namespace wording_test {

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

}  // namespace wording_test
}  // namespace specimen
