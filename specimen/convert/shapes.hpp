/// How the values of a map lie in the picture: in which pieces, how large, and what touches what.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// The pixels of one value. An edge is one of the four sides of a pixel.
struct ValueShape {
  double area = 0;       ///< [px]
  double pieces = 0;     ///< connected pieces [-]
  double largest = 0;    ///< area of the largest of them [px]
  double typical = 0;    ///< mean over the pixels of the area of the piece that a pixel is part of [px]
  double perimeter = 0;  ///< edges shared with other values
  double reach = 0;      ///< edges of its largest piece over all edges between values in the picture [-]
  double border = 0;     ///< share of the border of the picture along its largest piece [-]
  /// Mean width of a band of this area and perimeter [px].
  [[nodiscard]] double thickness() const { return perimeter > 0 ? 2 * area / perimeter : area; }
};

struct Shapes {
  std::vector<ValueShape> of;  ///< by value
  Raster<double> contact;      ///< edges that two values share, shape (values, values); empty for many values
};

inline constexpr int most_in_contact = 256;  ///< values up to which Shapes::contact is counted

/// Shapes of the values 0 ... count - 1 of a raster; pixels below 0 are no part of the picture.
[[nodiscard]] Shapes shapes_of(const Raster<std::int32_t>& code, int count);

/// How many other values each value touches by an edge; pixels below 0 count as nothing.
[[nodiscard]] std::vector<int> neighbours_of(const Raster<std::int32_t>& code, int count);

/// Share of the pixels of each value that at least three of their eight neighbours agree with [-]: near 1 for
/// regions, near 0 for the values in between that smooth edges have.
[[nodiscard]] std::vector<double> solidity(const Raster<std::int32_t>& code, int count);

}  // namespace specimen
