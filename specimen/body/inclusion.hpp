/// Aggregates as the specimen knows them: ellipses that were placed, or contours that were found.
#pragma once

#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {

/// One aggregate.
struct Inclusion {
  int id = 0;                      ///< 1, 2, ...: its value in the instance picture
  Ellipse ellipse;                 ///< the ellipse itself, or the one with the same area and second moments
  std::vector<Point> contour;      ///< outer boundary [m], counter-clockwise; empty: the ellipse is exact
  double area = 0;                 ///< [m^2]
  double perimeter = 0;            ///< [m]
  double equivalent_diameter = 0;  ///< diameter of the circle of the same area [m]
  double orientation = 0;          ///< of the long axis against x, [0, pi) [rad]
};

/// Closed polygon round one aggregate along which its ITZ lies.
struct Ring {
  int inclusion = 0;            ///< id of the inclusion
  std::vector<Point> vertices;  ///< corners [m], counter-clockwise; 36 of them by default
};

/// Inclusion of an exact ellipse (perimeter to round-off).
[[nodiscard]] Inclusion make_inclusion(int id, const Ellipse& ellipse);

}  // namespace specimen
