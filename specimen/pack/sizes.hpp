/// The sizes of the aggregates of one specimen, drawn from a grading.
#pragma once

#include <vector>

#include "specimen/pack/grading.hpp"
#include "specimen/body/random.hpp"

namespace specimen {

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
