#include "apps/export/imagej.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace inclusion_table_test {

TEST(InclusionTable, HasUnitsInItsHeaderAndALineAnInclusion) {
  specimen::Inclusion inclusion;
  inclusion.id = 7;
  inclusion.ellipse = {10e-3, 20.5e-3, 3e-3, 2e-3, std::numbers::pi / 6};
  inclusion.area = 18.75e-6;
  inclusion.perimeter = 16e-3;
  inclusion.equivalent_diameter = 4.9e-3;
  inclusion.orientation = std::numbers::pi / 4;
  EXPECT_EQ(exchange::inclusion_table({inclusion}),
            "id,x_mm,y_mm,a_mm,b_mm,angle_deg,area_mm2,perimeter_mm,equivalent_diameter_mm,orientation_deg\n"
            "7,10,20.5,3,2,30,18.75,16,4.9,45\n");
}

TEST(InclusionTable, OfNoneIsAHeader) {
  EXPECT_EQ(exchange::inclusion_table({}).find('\n'), exchange::inclusion_table({}).size() - 1);
}

}  // namespace inclusion_table_test
