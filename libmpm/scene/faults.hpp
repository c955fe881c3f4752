/// All that is wrong with a scene at once; validate() throws the first of it.
#pragma once

#include <vector>

#include "libmpm/scene/error.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Every value of a phase that is out of range; none of a valid one.
[[nodiscard]] std::vector<Error> faults(const Phase& phase, Plane plane);

/// Every rule that a scene breaks; none of a valid one.
[[nodiscard]] std::vector<Error> faults(const Scene& scene);

/// Those that can be told before there is a specimen: labels, pixel size, phases and extra points are not
/// looked at.
[[nodiscard]] std::vector<Error> faults_beside_specimen(const Scene& scene);

}  // namespace mpm
