/// How much fitted parameters would differ with other random strengths.
#pragma once

#include <optional>
#include <vector>

#include "apps/calibrate/calibration.hpp"

namespace app {

/// Relative standard deviation of each parameter: that of the mean peak over seeds, carried over to the
/// parameters by the slopes that the evaluations near the best one show.
/// @return nullopt where a curve was aimed at, where there are more parameters than figures of the peak, and
/// where evaluations or runs are too few to tell.
[[nodiscard]] std::optional<std::vector<double>> parameter_spread(const CalibrationTask& task,
                                                                  const Calibration& calibration);

}  // namespace app
