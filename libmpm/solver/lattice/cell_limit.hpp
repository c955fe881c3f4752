/// How long a time step small strain bears, whatever the picture.
#pragma once

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// Longest time step with which each cell alone is stable [s]: then all together are, for
/// failures take stiffness away and leave the mass. The true limit of the specimen is longer by some per
/// cent, and no shorter.
///
/// The mass of a node is shared out among its cells in proportion to their stiffness there. What platens hold
/// is taken to be free, which only makes the limit shorter. Infinite where nothing has any stiffness.
/// Source: Irons, Treharne (1971): the largest frequency of an assembly is no larger than that of its parts.
[[nodiscard]] double cell_limit(const Scene& scene, const Plan& plan);

}  // namespace mpm
