#include "apps/export/inclusion_table.hpp"

#include <fmt/format.h>

#include <numbers>

namespace exchange {

std::string inclusion_table(const std::vector<specimen::Inclusion>& inclusions) {
  constexpr double mm = 1e3;
  constexpr double mm2 = 1e6;
  constexpr double deg = 180 / std::numbers::pi;
  std::string table =
      "id,x_mm,y_mm,a_mm,b_mm,angle_deg,area_mm2,perimeter_mm,equivalent_diameter_mm,orientation_deg\n";
  for (const specimen::Inclusion& inclusion : inclusions) {
    const specimen::Ellipse& ellipse = inclusion.ellipse;
    table += fmt::format("{},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n",
                         inclusion.id, mm * ellipse.x, mm * ellipse.y, mm * ellipse.a, mm * ellipse.b,
                         deg * ellipse.angle, mm2 * inclusion.area, mm * inclusion.perimeter,
                         mm * inclusion.equivalent_diameter, deg * inclusion.orientation);
  }
  return table;
}

}  // namespace exchange
