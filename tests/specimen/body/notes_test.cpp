#include "specimen/body/measure.hpp"

#include <gtest/gtest.h>

namespace notes_test {

TEST(Notes, FiguresReadWell) {
  EXPECT_EQ(specimen::grouped(0), "0");
  EXPECT_EQ(specimen::grouped(999), "999");
  EXPECT_EQ(specimen::grouped(1234567), "1,234,567");
  EXPECT_EQ(specimen::grouped(-123456), "-123,456");
  EXPECT_EQ(specimen::counted(1, "island"), "1 island");
  EXPECT_EQ(specimen::counted(1234, "island"), "1,234 islands");
  EXPECT_EQ(specimen::share_text(32, 1000), "3.2 %");
  EXPECT_EQ(specimen::share_text(4, 100000), "0.004 %");
  EXPECT_EQ(specimen::share_text(0, 10), "0 %");
  EXPECT_EQ(specimen::length_text(0.5e-3), "0.5 mm");
  EXPECT_EQ(specimen::area_text(2.5e-6), "2.5 mm2");
  EXPECT_EQ(specimen::short_number(0.1 + 0.2), "0.3");
}

}  // namespace notes_test
