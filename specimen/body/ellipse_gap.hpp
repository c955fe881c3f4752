/// The exact gap test for ellipses.
///
/// For a unit vector u, the support function h(u) = sqrt(u.Q u), Q = R diag(a^2, b^2) R^T, is the extent of
/// an ellipse from its centre along u. With r from the first centre to the second,
///   f(u) = u.r - h1(u) - h2(u)
/// is the width of the empty strip normal to u between the two, and the Euclidean gap is the largest f. The
/// vector p between the two support points has the components f along u and f' = df/dtheta normal to it, and
/// for no direction v is f larger than p.v. So one evaluation bounds the gap: f <= gap <= |p|.
#pragma once

#include "specimen/body/ellipse.hpp"

namespace specimen {

/// An ellipse with precomputed data for the gap test.
struct Body {
  Point centre;   ///< [m]
  double a = 0;   ///< long semi-axis [m]
  double b = 0;   ///< short semi-axis [m]
  Rotation axis;  ///< direction of the long axis
};
[[nodiscard]] Body body_of(const Ellipse& e);

/// Farthest point of the body along the unit vector u, from its centre [m].
[[nodiscard]] Point support_point(const Body& body, Point u);

/// The strip between two bodies across one direction.
struct Strip {
  double width = 0;      ///< f [m]; negative: the bodies overlap along u
  double slope = 0;      ///< f' = df/dtheta [m]
  double curvature = 0;  ///< f + rho1 + rho2 = -f'' [m]; > 0 near a maximum
};
/// @param u  unit vector.
[[nodiscard]] Strip strip_between(const Body& first, const Body& second, Point u);

/// Result and cost of the gap test.
struct GapAnswer {
  bool separated = false;
  int evaluations = 0;  ///< number of evaluations of the strip
};

/// Whether the Euclidean gap is at least `gap` [m] (>= 0). Exact up to the rounding of the strip's width
/// (about 1e-16 of the size); always terminates, also for bodies that touch.
[[nodiscard]] GapAnswer test_gap(const Body& first, const Body& second, double gap);

/// The unit vector at a local maximum of the strip's width, by Newton's method from the unit vector `u`.
[[nodiscard]] Point widest_direction_from(const Body& first, const Body& second, Point u);

/// Euclidean gap [m]; negative: the smallest translation that separates the bodies.
[[nodiscard]] double exact_gap(const Body& first, const Body& second);

}  // namespace specimen
