/// Long lines made short without a change that can be seen.
#pragma once

#include <vector>

#include "apps/drawing/drawing.hpp"

namespace output {

/// Runs of points that are finite; a run of one point is dropped.   @pre x and y have one length.
[[nodiscard]] std::vector<std::vector<Place>> unbroken_lines(const std::vector<double>& x,
                                                             const std::vector<double>& y);

/// Of the points in each half column of pixels, in their order: the first, the lowest, the highest and the
/// last.
[[nodiscard]] std::vector<Place> thin_line(const std::vector<Place>& places);

}  // namespace output
