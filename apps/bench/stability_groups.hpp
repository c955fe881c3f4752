/// The cases by group.
#pragma once

#include <vector>

#include "apps/bench/stability_case.hpp"

namespace app::bench {

[[nodiscard]] std::vector<StabilityCase> material_cases();   ///< stiffness, Poisson's ratio, density
[[nodiscard]] std::vector<StabilityCase> strength_cases();   ///< what fails, down to the last point
[[nodiscard]] std::vector<StabilityCase> geometry_cases();   ///< pictures at their extremes
[[nodiscard]] std::vector<StabilityCase> point_cases();      ///< points a cell, and where they stand in it
[[nodiscard]] std::vector<StabilityCase> time_step_cases();  ///< on both sides of the critical step
[[nodiscard]] std::vector<StabilityCase> loading_cases();    ///< speed and ramp of the platen
[[nodiscard]] std::vector<StabilityCase> motion_cases();     ///< points that move
[[nodiscard]] std::vector<StabilityCase> turning_cases();    ///< and turn
[[nodiscard]] std::vector<StabilityCase> number_cases();     ///< precision, and numbers that are hardly any

}  // namespace app::bench
