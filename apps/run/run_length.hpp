/// How long a run will take, for who starts it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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

/// What an explicit run computes; 0 for one without inertia, whose states are not known beforehand.
struct RunSize {
  std::int64_t points = 0;
  std::int64_t steps = 0;
  [[nodiscard]] double updates() const { return static_cast<double>(points) * static_cast<double>(steps); }
};

/// @throws mpm::Error for an invalid scene.
[[nodiscard]] RunSize size_of(const mpm::Scene& scene);

/// Expected wall time of runs side by side, each on one thread [s]; 0 where they are certainly short.
/// @param sample  makes one of the scenes, on which the speed is measured where that is worth it.
/// @param workers  runs at a time.
[[nodiscard]] double time_of_runs(const std::vector<RunSize>& runs, const std::function<mpm::Scene()>& sample,
                                  int workers);

/// Whether a wall time is said beforehand [s].
[[nodiscard]] bool is_long(double seconds);

/// A picture has the pixels of its camera, which nobody may have meant to be computed.
/// @param columns  of the specimen.
/// @throws Rejected (Exit::data) beyond ten minutes, with the columns that take less.
void refuse_unasked_length(const RunLength& length, int columns);

/// Points, steps and expected time of a long explicit run: one of a minute or more, or of half a million
/// steps. The time is measured on its first steps, which takes less than a second. Empty for others.
/// @throws mpm::Error for an invalid scene.
[[nodiscard]] std::string announcement(const mpm::Scene& scene);

}  // namespace app
