/// How long a run will take, for who starts it.
#pragma once

#include <string>

#include "libmpm/scene/scene.hpp"

namespace app {

/// "10 s", "12 min", "3.4 h", "5 days".
[[nodiscard]] std::string duration_text(double seconds);

/// What a long explicit run takes.
struct RunLength {
  double seconds = 0;  ///< expected wall time; 0: it is a short one, or one without inertia
  std::string text;    ///< points, steps and expected time
};

/// Measured as for announcement().   @throws mpm::Error for an invalid scene.
[[nodiscard]] RunLength length_of(const mpm::Scene& scene);

/// A picture has the pixels of its camera, which nobody may have meant to be computed.
/// @param columns  of the specimen.
/// @throws Rejected (Exit::data) beyond ten minutes, with the columns that take less.
void refuse_unasked_length(const RunLength& length, int columns);

/// Points, steps and expected time of a long explicit run: one of a minute or more, or of half a million
/// steps. The time is measured on its first steps, which takes less than a second. Empty for others.
/// @throws mpm::Error for an invalid scene.
[[nodiscard]] std::string announcement(const mpm::Scene& scene);

}  // namespace app
