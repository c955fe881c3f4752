/// The critical time step of the cells at small strain, for messages and the bench. The step of a run is
/// chosen in plan.cpp.
#pragma once

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// Longest time step for which every cell alone is stable [s]. Then the whole specimen is stable, also after
/// failures, which reduce the stiffness but not the mass. The true limit is a few per cent longer.
///
/// The mass of a node is distributed to its cells in proportion to their stiffness. Nodes on platens count as
/// free, which only makes the limit shorter. Infinite without any stiffness. Source: Irons, Treharne (1971):
/// the largest frequency of an assembly is no larger than that of its parts.
[[nodiscard]] double cell_limit(const Scene& scene, const Plan& plan);

}  // namespace mpm
