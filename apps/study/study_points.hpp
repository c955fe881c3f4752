/// Where the points of a study lie in the space of its parameters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "apps/study/study.hpp"

namespace app {

/// Points of Sobol's sequence in [0, 1)^dimensions from its point 1 on, one behind the other. More points
/// begin with the same ones. At most 1000 dimensions.
/// Source: Joe and Kuo (2008), Constructing Sobol sequences with better two-dimensional projections.
[[nodiscard]] std::vector<std::vector<double>> sobol_points(std::size_t dimensions, std::size_t count);

/// Points of a Latin hypercube in [0, 1)^dimensions: along each axis one point lies in each of `count`
/// strata, anywhere in it. The same on every machine.
/// Source: McKay, Beckman, Conover (1979).
[[nodiscard]] std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                               std::uint64_t seed);

/// Values of the parameters at every point of a plan, point by point: one point without values where only
/// seeds vary. Of a grid the last parameter changes first.
/// @throws Rejected (Exit::data) for a grid of more than 100 000 points.
[[nodiscard]] std::vector<std::vector<Value>> points_of(const StudyPlan& plan);

}  // namespace app
