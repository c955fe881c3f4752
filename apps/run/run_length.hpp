/// How long a run will take, for who starts it.
#pragma once

#include <string>

#include "libmpm/scene/scene.hpp"

namespace app {

/// "10 s", "12 min", "3.4 h", "5 days".
[[nodiscard]] std::string duration_text(double seconds);

/// Points, steps and expected time of a long explicit run: one of a minute or more, or of half a million
/// steps. The time is measured on its first steps, which takes less than a second. Empty for others.
/// @throws mpm::Error for an invalid scene.
[[nodiscard]] std::string announcement(const mpm::Scene& scene);

}  // namespace app
