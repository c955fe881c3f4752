/// Ellipses and the exact gap between two of them.
/// Aggregates as the specimen knows them: ellipses that were placed, or contours that were found.
/// Sine and cosine of an angle, the same bits on every machine.
#pragma once

#include <vector>

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

/// The unit vector at an angle against x: (cos, sin).
struct Rotation {
  double cos = 1;
  double sin = 0;
};

/// Rotation by an angle [rad], to about one unit in the last place within a turn or two.
/// The mathematical library picks its sine by processor, so two machines may differ in the last bit, and a
/// packing that is relaxed over hundreds of sweeps magnifies that bit into another specimen. Only +, -, *
/// and exact functions are used here.
[[nodiscard]] Rotation rotation_by(double angle);

}  // namespace specimen
