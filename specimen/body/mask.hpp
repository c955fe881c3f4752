/// The labelled mask: the phase of each pixel of the specimen.
///
/// Orientation, defined here once: row 0 is the TOP of the picture; x points right, y points UP;
/// the origin is the bottom left corner of the specimen. The centre of pixel (row, col) lies at
///   x = (col + 1/2) d,   y = (rows - row - 1/2) d,   d = pixel_size,
/// so the bottom left pixel (rows - 1, 0) has its centre half a pixel inside both edges.
///
/// Also: vectors in the plane, and connected components of a picture.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// Position or vector in the plane of the specimen [m].
struct Point {
  double x = 0;  ///< to the right [m]
  double y = 0;  ///< upwards [m]
  friend bool operator==(const Point&, const Point&) = default;
};

/// Labels with a fixed meaning; labels above 3 are phases named by the user, up to 255.
namespace phase {
inline constexpr std::uint8_t void_ = 0;
inline constexpr std::uint8_t aggregate = 1;
inline constexpr std::uint8_t mortar = 2;
inline constexpr std::uint8_t itz = 3;
}  // namespace phase

/// Names of the four phases with fixed labels, by label.
[[nodiscard]] std::vector<std::string> standard_phases();

/// The phase of each pixel of a specimen.
struct LabelledMask {
  Raster<std::uint8_t> labels;  ///< label per pixel, shape (rows, cols), row 0 at the top
  double pixel_size = 0;        ///< edge of a pixel [m], > 0
  std::vector<std::string> phases = standard_phases();  ///< phases[label] is the name of the label

  [[nodiscard]] double width() const { return labels.cols * pixel_size; }   ///< [m]
  [[nodiscard]] double height() const { return labels.rows * pixel_size; }  ///< [m]
  /// Centre of a pixel [m].
  [[nodiscard]] Point centre(int row, int col) const {
    return {(col + 0.5) * pixel_size, (labels.rows - row - 0.5) * pixel_size};
  }
  friend bool operator==(const LabelledMask&, const LabelledMask&) = default;
};

/// Label of a phase name; adds the name to `phases` if it is new.
/// @throws Error if 256 phases have names already, or the name is empty.
std::uint8_t label_of(std::vector<std::string>& phases, std::string_view name);

/// Number of pixels per label, shape (phases.size()).
[[nodiscard]] std::vector<std::int64_t> count_labels(const LabelledMask& mask);

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

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

/// Which neighbouring pixels are connected.
enum class Connectivity {
  edges,    ///< the 4 that share an edge
  corners,  ///< the 8 that share an edge or a corner
};

/// Connected components of equal value, numbered 0, 1, ... in row-by-row order.
struct Components {
  Raster<std::int32_t> piece;      ///< number of the component of each pixel
  std::vector<std::int64_t> area;  ///< pixels per component
  [[nodiscard]] int count() const { return static_cast<int>(area.size()); }
};

/// Connected components of equal value.
[[nodiscard]] Components connected_pieces(const Raster<std::int32_t>& values, Connectivity connectivity);
[[nodiscard]] Components connected_pieces(const Raster<std::uint8_t>& values, Connectivity connectivity);

}  // namespace specimen
