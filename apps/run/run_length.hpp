/// How long a run will take, for who starts it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace app {

/// "10 s", "12 min", "3.4 h", "5 days".
[[nodiscard]] std::string duration_text(double seconds);

/// What a long run takes.
struct RunLength {
  double seconds = 0;  ///< expected wall time, of one without inertia roughly; 0: it is a short one
  std::string text;    ///< points, steps and expected time
};

/// Measured as for announcement().   @throws mpm::Error for an invalid scene.
[[nodiscard]] RunLength length_of(const mpm::Scene& scene);

/// What a run computes.
struct RunSize {
  std::int64_t points = 0;
  std::int64_t steps = 0;     ///< without inertia: states in equilibrium, roughly
  bool quasi_static = false;  ///< without inertia
  [[nodiscard]] double updates() const { return static_cast<double>(points) * static_cast<double>(steps); }
};

/// @throws mpm::Error for an invalid scene.
[[nodiscard]] RunSize size_of(const mpm::Scene& scene);

/// The largest of several runs: "2500 points and 8000 steps", "... and roughly 300 states in equilibrium".
[[nodiscard]] std::string size_text(const std::vector<RunSize>& runs);

/// Of an expected time: "up to" where a drop of the stress may end a run before, else "about"; "roughly"
/// where a run without inertia is among them.
[[nodiscard]] const char* precision_word(const std::vector<RunSize>& runs, bool may_end_before);

/// Expected wall time of runs side by side, each on one thread [s]; 0 where they are certainly short.
/// @param sample  makes the scene of a run, by its place in the list; the speed is measured on the largest
/// with inertia and the largest without, where that is worth it.   @param workers  runs at a time.
[[nodiscard]] double time_of_runs(const std::vector<RunSize>& runs,
                                  const std::function<mpm::Scene(std::size_t)>& sample, int workers);

/// Whether a wall time is said beforehand [s].
[[nodiscard]] bool is_long(double seconds);

/// A picture has the pixels of its camera, which nobody may have meant to be computed.
/// @param columns  of the specimen.
/// @throws Rejected (Exit::data) beyond ten minutes, with the columns that take less.
void refuse_unasked_length(const RunLength& length, int columns);

/// Points, steps and expected time of a long run: one of a minute or more, or of half a million steps. The
/// time is measured on its first steps, which takes less than a second, or on its first states in
/// equilibrium. Empty for others.
/// @throws mpm::Error for an invalid scene.
[[nodiscard]] std::string announcement(const mpm::Scene& scene);

}  // namespace app
