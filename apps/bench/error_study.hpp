/// Error against run time: problems with a known answer, solved in many ways, and what that found.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "apps/system/job_pool.hpp"

namespace app::bench {

/// What one run gives.
struct Measured {
  double value = 0;      ///< the error itself, or the quantity where the problem has a reference run
  double wall_time = 0;  ///< of the time loop [s]
  std::int64_t point_updates = 0;
  std::string trouble;  ///< empty: it came to its end
};

using Run = std::function<Measured()>;

/// A way to solve a problem, refined step by step: a line of the chart.
struct Method {
  std::string name;           ///< "GIMP MUSL FLIP"
  std::string refined;        ///< what falls along the line: "cell", "pixel", "velocity"
  std::string unit;           ///< of its sizes; empty = over the specimen
  std::vector<double> sizes;  ///< in that unit, falling
  std::vector<Run> runs;      ///< as many
};

struct Problem {
  std::string name;      ///< as a user names it: "bar"
  std::string title;     ///< "Axial vibration of a bar"
  std::string quantity;  ///< which error, in words
  std::string answer;    ///< where the right answer comes from
  std::string remark;    ///< what the error shows
  Run reference;         ///< a slow and fine run, where no closed form is known; may be empty
  std::vector<Method> methods;
};

/// A run of a method, judged.
struct Sample {
  double size = 0;
  double error = 0;  ///< [-]; not a number where the run came to no end
  double wall_time = 0;
  std::int64_t point_updates = 0;
  std::string trouble;
  bool in_front = false;  ///< no other run of the problem is both faster and more exact
};

struct MethodResult {
  const Method* method = nullptr;
  std::vector<Sample> samples;
  double order =
      0;  ///< power of the size with which the error falls [-]; not a number for fewer than three samples,
          ///< and where it does not fall from each to the next: then something else than the size rules it
};

struct ProblemResult {
  Problem problem;
  double reference_value = 0, reference_time = 0;  ///< [s]; where there is a reference run
  std::vector<MethodResult> methods;
};

/// All runs of the problems one after the other, so that each has the machine to itself; short ones again,
/// until they took 0.1 s or were run five times, and the median counts.
/// @return results of the problems that came to their end before the watch said no.
[[nodiscard]] std::vector<ProblemResult> study_errors(const std::vector<Problem>& problems,
                                                      const Watch& watch);

/// The fastest run whose error is at most `tolerance`; null where no run is that exact.
struct Cheapest {
  const Method* method = nullptr;
  const Sample* sample = nullptr;
};
[[nodiscard]] Cheapest cheapest_within(const ProblemResult& result, double tolerance);

/// The most exact run of all.   @pre some run came to its end.
[[nodiscard]] Cheapest most_exact(const ProblemResult& result);

/// One chart a problem, error against wall time, and the cheapest way to 5 %, 1 % and 0.1 %.
[[nodiscard]] std::string error_html(const std::vector<ProblemResult>& results);

/// The chart of a problem as PNG, twice its size on the page.
[[nodiscard]] std::string error_png(const ProblemResult& result);

/// A line a run: problem, method, what is refined, its size, error, wall time, point-updates, order, front.
[[nodiscard]] std::string error_csv(const std::vector<ProblemResult>& results);

/// For the console: the cheapest ways, a line a problem and tolerance.
[[nodiscard]] std::string error_text(const std::vector<ProblemResult>& results);

}  // namespace app::bench
