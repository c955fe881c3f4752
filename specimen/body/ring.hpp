/// The interfacial transition zone (ITZ): a closed polygon around every aggregate, drawn over mortar pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {

/// How the ITZ is represented.
enum class ItzMode {
  ring,    ///< as pixels
  points,  ///< as extra material points at the vertices, as in the paper; the mask does not change
  none,    ///< not at all
};

/// Options of the ITZ.
struct ItzOptions {
  ItzMode mode = ItzMode::ring;
  double thickness = 0;  ///< of the ring [m]; 0 = one pixel
  /// Vertices of a ring, >= 3; 0 = 36 along an ellipse (as in the paper) and for points, otherwise as many as
  /// follow the contour in steps of at most three pixels.
  int segments = 0;
  friend bool operator==(const ItzOptions&, const ItzOptions&) = default;
};

/// Rings of an inclusion: one along an ellipse, with vertices at equal steps of its parameter (as in the
/// paper), or one along each closed line of a contour (each piece, each hole), with vertices at equal arc
/// length.
/// @param segments  vertices of each; 0 = 36, and at least one for each three points of a contour.
/// @throws Error for fewer than 3 segments.
[[nodiscard]] std::vector<Ring> make_rings(const Inclusion& inclusion, int segments);

/// Draw one ring into the mask: mortar pixels whose centre is within `thickness` of the polygon, and mortar
/// pixels that share an edge with the inclusion, become ITZ. So the ring is closed at any thickness. Where
/// two inclusions share an edge, the pixel of the larger one becomes ITZ, so that they do not grow together.
/// The cost is one pass over the mask plus the pixels near the polygon.
/// @param instances  id of the inclusion per pixel, shape of the mask.   @param thickness  [m], > 0.
/// @throws Error for a thickness <= 0, or instances of another shape.
void draw_ring(LabelledMask& mask, const Raster<std::int32_t>& instances, const Ring& ring, double thickness);

/// The same for many rings, in one pass over the mask.
void draw_rings(LabelledMask& mask, const Raster<std::int32_t>& instances, const std::vector<Ring>& rings,
                double thickness);

}  // namespace specimen
