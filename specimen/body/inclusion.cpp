#include "specimen/body/inclusion.hpp"

#include <cmath>
#include <numbers>

namespace specimen {

Inclusion make_inclusion(int id, const Ellipse& ellipse) {
  Inclusion inclusion;
  inclusion.id = id;
  inclusion.ellipse = ellipse;
  inclusion.area = area(ellipse);
  inclusion.perimeter = perimeter(ellipse);
  inclusion.equivalent_diameter = 2 * std::sqrt(ellipse.a * ellipse.b);
  constexpr double pi = std::numbers::pi;
  inclusion.orientation = ellipse.angle - pi * std::floor(ellipse.angle / pi);
  if (inclusion.orientation >= pi) inclusion.orientation = 0;  // a tiny negative angle rounds up to pi
  return inclusion;
}

}  // namespace specimen
