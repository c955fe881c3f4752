/// Gradings: the sizes of the aggregates and their shares; and sizes drawn from a grading.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// One size class. The diameter of an aggregate is that of the circle with the same area.
struct SizeClass {
  double d_min = 0;  ///< smallest diameter [m]
  double d_max = 0;  ///< largest diameter [m]
  double share = 0;  ///< share of the aggregate area [-]
};

/// Size classes in decreasing order; the shares add up to 1.
using Grading = std::vector<SizeClass>;

/// Grading of a named sieve curve between two diameters [m].
/// @param name  fuller, or A8 B8 C8 A16 B16 C16 A32 B32 C32 (DIN 1045-2).   @param walraven  convert the
/// volume shares of the curve to the area shares in a plane cut.
/// @throws Error for an unknown name (with a suggestion) or an empty range.
/// Source: Fuller, Thompson (1907); Walraven (1980).
[[nodiscard]] Grading named_grading(std::string_view name, double d_min, double d_max, bool walraven = false);

/// Names for named_grading().
[[nodiscard]] std::vector<std::string> grading_names();

/// Check a grading.   @throws Error if it is empty, not in decreasing order, or its shares do not add up
/// to 1.
void check(const Grading& grading);

/// Expected number of aggregates for a total aggregate area [m^2].
[[nodiscard]] double expected_count(const Grading& grading, double area);

/// Draw equivalent diameters [m], in decreasing order, whose areas add up to `area` [m^2] exactly.
/// Within a class the area is distributed evenly over the diameter. The remainder of a class is carried over
/// to the next one, so the sieve curve deviates by at most half an aggregate.
/// @throws Error if no number of aggregates of these sizes has this area.
[[nodiscard]] std::vector<double> draw_sizes(const Grading& grading, double area, Random& random);

}  // namespace specimen
