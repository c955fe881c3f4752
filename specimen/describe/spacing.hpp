/// How near aggregates lie to each other, and how far they are from being convex.
#pragma once

#include <vector>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// Distance from the outline of each inclusion to the nearest outline of another one [m], in the order of
/// the list; nought where they touch. Outlines are looked at a pixel apart, so distances are right to a
/// fraction of a pixel. Empty with fewer than two inclusions.
[[nodiscard]] std::vector<double> nearest_gaps(const Specimen& specimen);

/// Area over that of the convex hull [-]; 1 for an exact ellipse. Grains that were taken for one are low.
[[nodiscard]] double solidity(const Inclusion& inclusion);

}  // namespace specimen
