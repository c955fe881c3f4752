/// Ellipses and the exact gap between two of them.
#pragma once

#include "specimen/body/mask.hpp"

namespace specimen {

/// An ellipse in the plane of the specimen.
struct Ellipse {
  double x = 0;      ///< centre [m]
  double y = 0;      ///< centre [m]
  double a = 0;      ///< long semi-axis [m], >= b
  double b = 0;      ///< short semi-axis [m], > 0
  double angle = 0;  ///< of the long axis against x, counter-clockwise [rad]
  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

[[nodiscard]] double area(const Ellipse& e);       ///< [m^2]
[[nodiscard]] double perimeter(const Ellipse& e);  ///< [m]
[[nodiscard]] bool contains(const Ellipse& e, Point p);

/// Half the width of the ellipse along x and along y [m].
[[nodiscard]] Point half_extent(const Ellipse& e);

/// True when the Euclidean gap between the two ellipses is at least `gap` [m] (gap >= 0).
/// Source: maximum over directions of the separation of the support functions; one evaluation bounds it from
/// below and above, so the answer is exact, at any aspect, and needs about two evaluations on average.
[[nodiscard]] bool separated(const Ellipse& first, const Ellipse& second, double gap);

/// Euclidean gap [m]; for overlapping ellipses minus the least translation that separates them.
[[nodiscard]] double gap_between(const Ellipse& first, const Ellipse& second);

}  // namespace specimen
