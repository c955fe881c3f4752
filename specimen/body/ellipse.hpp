/// Aggregates: ellipses that were placed, or contours that were found in a picture; the exact gap between two
/// ellipses; rotations with the same bits on every machine.
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
  double angle = 0;  ///< from x to the long axis, counter-clockwise [rad]
  friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

[[nodiscard]] double area(const Ellipse& e);             ///< [m^2]
[[nodiscard]] double perimeter(const Ellipse& e);        ///< [m]
[[nodiscard]] bool contains(const Ellipse& e, Point p);  ///< p [m] lies inside or on the outline

/// Half the width of the ellipse along x and along y [m].
[[nodiscard]] Point half_extent(const Ellipse& e);

/// True when the Euclidean gap between the two ellipses is at least `gap` [m] (gap >= 0).
/// Method: the gap is the maximum over all directions of the separation by support functions. One evaluation
/// bounds it from both sides, so the answer is exact for any aspect ratio, after about two evaluations on
/// average.
[[nodiscard]] bool separated(const Ellipse& first, const Ellipse& second, double gap);

/// Euclidean gap [m]; for overlapping ellipses minus the smallest translation that separates them.
[[nodiscard]] double gap_between(const Ellipse& first, const Ellipse& second);

/// One aggregate.
struct Inclusion {
  int id = 0;       ///< 1, 2, ...: its value in Segmented::instances
  Ellipse ellipse;  ///< the ellipse itself, or the one with the same area and second moments
  /// Boundary [m], see loops_of(); empty: the ellipse is exact.
  std::vector<Point> contour;
  double area = 0;                 ///< [m^2]
  double perimeter = 0;            ///< [m]
  double equivalent_diameter = 0;  ///< diameter of the circle of the same area [m]
  double orientation = 0;          ///< from x to the long axis [rad], in [0, pi)
};

/// The closed lines that a contour is made of: the outer boundary of the largest piece, counter-clockwise;
/// then those of further pieces, and of holes, clockwise. In the contour each further one is closed by its
/// own first point and leads back to the first point of all, so that the whole is one polygon whose area is
/// that of the grain: its bridges are walked in both directions.
[[nodiscard]] std::vector<std::vector<Point>> loops_of(const std::vector<Point>& contour);
/// The other way round.
[[nodiscard]] std::vector<Point> contour_of(const std::vector<std::vector<Point>>& loops);

/// Closed polygon along one boundary of an aggregate; its ITZ lies along it.
struct Ring {
  int inclusion = 0;            ///< id of the inclusion
  std::vector<Point> vertices;  ///< corners [m], counter-clockwise, clockwise in a hole
};

/// The inclusion of an ellipse; area and perimeter are exact to rounding.
[[nodiscard]] Inclusion make_inclusion(int id, const Ellipse& ellipse);

/// The unit vector at an angle from x.
struct Rotation {
  double cos = 1;  ///< [-]
  double sin = 0;  ///< [-]
};

/// Rotation by an angle [rad], accurate to about one unit in the last place for angles up to two turns.
/// The sine of the C library depends on the processor, so two machines may differ in the last bit, and the
/// relaxation of a packing would magnify this bit into another specimen. This function uses only +, -, * and
/// exact functions.
[[nodiscard]] Rotation rotation_by(double angle);

}  // namespace specimen
