/// The bench of limits: runs at the edge of what the solver bears, each with what must come of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/system/job_pool.hpp"

namespace app::bench {

/// What a case found.
struct Finding {
  bool holds = false;
  std::string seen;  ///< the figures that were measured, in words
};

struct StabilityCase {
  std::string name;              ///< as it is asked for, e.g. "contrast"
  std::string must;              ///< what must happen, in words
  std::function<Finding()> run;  ///< on the thread that calls; what it throws is a failure
  std::string group = {};        ///< heading under which it stands
};

/// The cases by group, which does not stand in them yet.
[[nodiscard]] std::vector<StabilityCase> material_cases();      ///< stiffness, Poisson's ratio, density
[[nodiscard]] std::vector<StabilityCase> strength_cases();      ///< what fails, down to the last point
[[nodiscard]] std::vector<StabilityCase> geometry_cases();      ///< pictures at their extremes
[[nodiscard]] std::vector<StabilityCase> point_cases();         ///< points a cell, and where they stand in it
[[nodiscard]] std::vector<StabilityCase> time_step_cases();     ///< on both sides of the critical step
[[nodiscard]] std::vector<StabilityCase> loading_cases();       ///< speed and ramp of the platen
[[nodiscard]] std::vector<StabilityCase> inertia_cases();       ///< what is not at rest, and is said
[[nodiscard]] std::vector<StabilityCase> quasi_static_cases();  ///< equilibrium without inertia
[[nodiscard]] std::vector<StabilityCase> motion_cases();        ///< points that move, meet and turn
[[nodiscard]] std::vector<StabilityCase> number_cases();  ///< precision, and numbers that are hardly any

/// In the order in which they are reported, those of a group one after the other; no name comes twice.
[[nodiscard]] const std::vector<StabilityCase>& stability_cases();

/// Cases by name, in the order of the table; all of them for no names.
/// @throws Rejected for a name that is none.
[[nodiscard]] std::vector<const StabilityCase*> select_cases(const std::vector<std::string>& names);

struct StabilityOptions {
  std::vector<std::string> cases;  ///< names; empty = all
  int workers = 1;                 ///< cases at a time, each on one thread
};

/// A case and what came of it.
struct StabilityRow {
  std::string name = {}, group = {}, must = {};
  bool done = false;  ///< false: interrupted before it was
  Finding finding = {};
  double seconds = 0;  ///< that it took
};

struct StabilityOutcome {
  std::vector<StabilityRow> rows;  ///< in the order of the table
  int workers = 1;
  double wall_time = 0;  ///< [s]
  bool interrupted = false;

  /// Whether every case was run and holds; what decides over the exit code.
  [[nodiscard]] bool holds() const;
};

/// @throws Rejected for a name that is no case. What a case throws is its finding.
[[nodiscard]] StabilityOutcome run_stability(const StabilityOptions& options, const Watch& watch);

/// The same for cases of one's own.
[[nodiscard]] StabilityOutcome run_cases(const std::vector<const StabilityCase*>& cases, int workers,
                                         const Watch& watch);

/// A table for the terminal, with the figures of each case and a line that sums up.
[[nodiscard]] std::string stability_text(const StabilityOutcome& outcome);

/// A page that needs no network.
[[nodiscard]] std::string stability_html(const StabilityOutcome& outcome);

/// A line a case: name, group, verdict, seconds, must, seen.
[[nodiscard]] std::string stability_csv(const StabilityOutcome& outcome);

}  // namespace app::bench
