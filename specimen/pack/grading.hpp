/// Which aggregate sizes, and how much of each.
/// The sizes of the aggregates of one specimen, drawn from a grading.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "specimen/body/raster.hpp"

namespace specimen {

/// One size class; the diameter of an aggregate is that of the circle of the same area.
struct SizeClass {
  double d_min = 0;  ///< [m]
  double d_max = 0;  ///< [m]
  double share = 0;  ///< of the aggregate area [-]
};

/// Size classes in falling order of size; the shares add up to 1.
using Grading = std::vector<SizeClass>;

/// Grading of a named sieve curve between two diameters [m].
/// Names: fuller; A8 B8 C8 A16 B16 C16 A32 B32 C32 (DIN 1045-2). `walraven` turns a volume curve into the
/// area shares of a plane cut.
/// @throws Error for an unknown name (with a suggestion) or an empty range.
[[nodiscard]] Grading named_grading(std::string_view name, double d_min, double d_max, bool walraven = false);

/// Names that named_grading knows.
[[nodiscard]] std::vector<std::string> grading_names();

/// @throws Error for a grading that is empty, not in falling order, or whose shares do not add up to 1.
void check(const Grading& grading);

/// Number of aggregates to expect for a total area [m^2].
[[nodiscard]] double expected_count(const Grading& grading, double area);

/// Diameters [m] of circles of the aggregates' areas, falling, that add up to `area` [m^2] exactly.
/// Within a class the area is spread evenly over the diameter. A class that ends part of an aggregate short
/// or over hands that on to the next one, so the sieve curve is nowhere off by more than half an aggregate.
/// @throws Error when no number of aggregates within the sizes has that area.
[[nodiscard]] std::vector<double> draw_sizes(const Grading& grading, double area, Random& random);

}  // namespace specimen
