/// The interfacial transition zone: a closed polygon round every aggregate, drawn over mortar pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {

enum class ItzMode {
  ring,    ///< ITZ pixels
  points,  ///< extra material points at the vertices, the mask stays as it is (the paper's way)
  none,
};

struct ItzOptions {
  ItzMode mode = ItzMode::ring;
  double thickness = 0;  ///< [m]; 0 = one pixel
  int segments = 36;     ///< corners of a ring, >= 3
  friend bool operator==(const ItzOptions&, const ItzOptions&) = default;
};

/// Ring of an inclusion: an exact ellipse is cut at equal steps of its parameter (as the paper does), a
/// contour at equal arc length.
/// @throws Error for fewer than 3 segments.
[[nodiscard]] Ring make_ring(const Inclusion& inclusion, int segments);

/// Draw one ring into the mask: mortar pixels whose centre lies within `thickness` of the polygon, and every
/// mortar pixel that shares an edge with the inclusion, become ITZ. The ring is therefore closed at any
/// thickness. The cost is that of the pixels near the polygon and of one look at every pixel of the mask.
/// @param instances  ids per pixel, shape of the mask.   @param thickness  [m], > 0.
/// @throws Error when the thickness or the shape is not.
void draw_ring(LabelledMask& mask, const Raster<std::int32_t>& instances, const Ring& ring, double thickness);

/// The same for many rings: one look at every pixel serves them all.
void draw_rings(LabelledMask& mask, const Raster<std::int32_t>& instances, const std::vector<Ring>& rings,
                double thickness);

}  // namespace specimen
