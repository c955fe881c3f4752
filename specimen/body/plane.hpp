/// Arithmetic of plane vectors.
#pragma once

#include <cmath>
#include <limits>

#include "specimen/body/mask.hpp"

namespace specimen {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

inline Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
inline Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
inline Point operator*(double factor, Point p) { return {factor * p.x, factor * p.y}; }
inline double dot(Point p, Point q) { return p.x * q.x + p.y * q.y; }
/// Out-of-plane component of p x q; > 0 when q lies counter-clockwise of p.
inline double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }
inline double length(Point p) { return std::sqrt(dot(p, p)); }
inline Point normalized(Point p) { return (1 / length(p)) * p; }
/// p turned by 90 degrees counter-clockwise.
inline Point turned_left(Point p) { return {-p.y, p.x}; }

}  // namespace specimen
