/// Fitting free parameters of a scene to a target.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/calibrate/calibration_target.hpp"
#include "apps/calibrate/free_parameters.hpp"
#include "apps/calibrate/trend_search.hpp"
#include "apps/run/seed_runs.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// What is fitted to what.
struct CalibrationTask {
  Settings settings;                   ///< of the scene, where the search begins
  const specimen::Specimen& specimen;  ///< its sides are whole numbers of cells
  Target target;
  std::vector<FreeParameter> parameters;  ///< at least one
  int seeds = 4;                          ///< from damage.seed on, the same for every set of parameters
  int further_seeds = 5;                  ///< behind those, on which the fit is tried
  double tolerance = 0.005;               ///< misfit at which the search ends [-], > 0
  int evaluations = 100;                  ///< of the search, at most
};

/// What came out.
struct Calibration {
  std::vector<Evaluation> history;  ///< in the order of the search
  std::size_t best = 0;             ///< of the history; nothing else is set where that is empty
  SearchEnd end = SearchEnd::goal;
  Settings settings;                  ///< of the best; its run goes past the peak, or to the end of the curve
  std::vector<SeedRun> runs;          ///< of these settings; of the search when that was interrupted
  std::vector<SeedRun> further_runs;  ///< with further seeds; none when the search was interrupted
  double misfit = 0;                  ///< of these runs [-]
  int run_count = 0;
  double wall_time = 0;  ///< [s]

  [[nodiscard]] const Evaluation& best_evaluation() const { return history[best]; }
};

/// Told each evaluation, and which is the best so far.
using CalibrationObserver = std::function<void(const Calibration& so_far)>;

/// Search for the parameters of least misfit, then run the scene that was found.
/// @param stopped  asked all the time by several threads; true = end, with the best so far.
/// @throws Rejected when no set of parameters near the start could be run.
[[nodiscard]] Calibration calibrate(const CalibrationTask& task, const std::function<bool()>& stopped,
                                    const CalibrationObserver& observer = {});

/// What a set of parameters takes, where all that may be tried take long: "each set of parameters takes about
/// 40 s here: 4 runs of ... points and ... steps, 2 at a time; at most 100 sets are tried". Measured within a
/// second; empty for a short search.   @throws mpm::Error for an invalid scene.
[[nodiscard]] std::string announcement(const CalibrationTask& task);

/// Relative standard deviation of each parameter: that of the mean peak over seeds, carried over to the
/// parameters by the slopes that the evaluations near the best one show.
/// @return nullopt where a curve was aimed at, where there are more parameters than figures of the peak, and
/// where evaluations or runs are too few to tell.
[[nodiscard]] std::optional<std::vector<double>> parameter_spread(const CalibrationTask& task,
                                                                  const Calibration& calibration);

}  // namespace app
